#include "core/bands/passing_runs.h"
#include "tests/catch.h"

#include <vector>

using namespace abbe;

namespace {

/// The runs of bands [first, last), found band by band.
std::vector<std::pair<int, int>> expected_runs(const std::vector<float>& values, int first,
                                               int last) {
  std::vector<std::pair<int, int>> runs;
  for (int b = first; b < last; ++b) {
    if (!(values[static_cast<std::size_t>(b)] > 0.0f)) continue;
    if (!runs.empty() && runs.back().second == b)
      ++runs.back().second;
    else
      runs.emplace_back(b, b + 1);
  }
  return runs;
}

std::vector<std::pair<int, int>> found_runs(const std::vector<float>& values, int first, int last) {
  std::vector<std::pair<int, int>> runs;
  for (const BandRange run : PassingRuns({values.data(), {first, last}}))
    runs.emplace_back(run.first, run.last);
  return runs;
}

} // namespace

TEST_CASE("runs agree with a search band by band, for all patterns of ten bands") {
  for (unsigned pattern = 0; pattern < 1024; ++pattern) {
    std::vector<float> values(16, 0.0f);
    for (unsigned b = 0; b < 10; ++b)
      values[b] = (pattern >> b & 1u) != 0 ? 0.5f : 0.0f;
    CAPTURE(pattern);
    CHECK(found_runs(values, 0, 10) == expected_runs(values, 0, 10));
    CHECK(found_runs(values, 3, 8) == expected_runs(values, 3, 8));
  }
}

TEST_CASE("every value above 0 passes, however small, and no other") {
  const std::vector<float> values{1e-45f, -1.0f, -0.0f, 1e30f};
  CHECK(found_runs(values, 0, 4) == std::vector<std::pair<int, int>>{{0, 1}, {3, 4}});
}

TEST_CASE("an empty range has no runs") {
  CHECK(found_runs({1.0f, 1.0f}, 1, 1).empty());
}
