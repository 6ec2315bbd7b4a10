#include "core/film/id_counts.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("ids are counted per pixel, and told the most frequent first") {
  IdCounts counts(2);
  CHECK(counts.of(0).empty());
  for (const std::uint32_t id : {7u, 9u, 4u, 9u, 4u, 9u, 0u})
    counts.add(1, id);
  CHECK(counts.of(1) == std::vector<IdCount>{{9, 3}, {4, 2}, {0, 1}, {7, 1}});
  CHECK(counts.of(0).empty());
  counts.add(0, 4, 5);
  counts.add(0, 4);
  CHECK(counts.of(0) == std::vector<IdCount>{{4, 6}});
}

TEST_CASE("pairs of ids and counts do not depend on the order in which they come") {
  IdCounts a(1), b(1);
  for (const std::uint32_t id : {1u, 2u, 3u, 2u, 3u})
    a.add(0, id);
  for (const std::uint32_t id : {3u, 3u, 2u, 1u, 2u})
    b.add(0, id);
  CHECK(a.of(0) == b.of(0));
  CHECK(a.of(0) == std::vector<IdCount>{{2, 2}, {3, 2}, {1, 1}});
}
