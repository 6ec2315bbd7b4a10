#include "core/bundles/band_partition.h"
#include "tests/catch.h"

#include <algorithm>
#include <functional>
#include <vector>

using namespace abbe;

namespace {

/// Rays that say what a function says, of ranges of which they have been told before.
struct Rays {
  std::function<BandVerdict(BandRange)> verdict;
  std::vector<BandRange> prepared = {};
  std::vector<int> sizes = {}; ///< of the ranges in the order in which they were judged
  bool asked_unprepared = false;

  void prepare(std::span<const BandRange> ranges) { prepared.assign(ranges.begin(), ranges.end()); }
  BandVerdict judge(BandRange range) {
    asked_unprepared |= std::none_of(prepared.begin(), prepared.end(), [&](const BandRange& r) {
      return r.first == range.first && r.last == range.last;
    });
    sizes.push_back(range.size());
    return verdict(range);
  }
};

BandVerdict always_apart(BandRange range) {
  return range.size() == 1 ? BandVerdict::together : BandVerdict::apart;
}

const BandShares& equal_shares() {
  static const BandShares shares(std::vector<double>(64, 1.0));
  return shares;
}

bool covers(std::vector<BandPart> parts, BandRange whole) {
  std::sort(parts.begin(), parts.end(),
            [](const BandPart& a, const BandPart& b) { return a.bands.first < b.bands.first; });
  int next = whole.first;
  for (const BandPart& part : parts) {
    if (part.bands.first != next || part.bands.empty()) return false;
    next = part.bands.last;
  }
  return next == whole.last;
}

} // namespace

TEST_CASE("bands that may go on together are one part") {
  BandPartition partition;
  Rays rays{[](BandRange) { return BandVerdict::together; }};
  const auto& parts = partition.part({3, 50}, equal_shares(), 64, rays);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].kind == BandPart::Kind::shared);
  CHECK(parts[0].bands.first == 3);
  CHECK(parts[0].bands.last == 50);
}

TEST_CASE("bands that are all apart end as single ones where there is room") {
  BandPartition partition;
  Rays rays{always_apart};
  const auto& parts = partition.part({8, 40}, equal_shares(), 32, rays);
  CHECK(parts.size() == 32);
  CHECK(covers(parts, {8, 40}));
  for (const BandPart& part : parts)
    CHECK(part.kind == BandPart::Kind::single);
  CHECK_FALSE(rays.asked_unprepared);
  CHECK(std::is_sorted(rays.sizes.rbegin(), rays.sizes.rend())); // large ranges come first
}

TEST_CASE("there are never more parts than are allowed, and together they are the whole") {
  BandPartition partition;
  for (std::size_t most = 1; most <= 70; ++most)
    for (const int largest_shared : {1, 3, 10}) {
      CAPTURE(most, largest_shared);
      Rays rays{[&](BandRange range) {
        return range.size() <= largest_shared ? BandVerdict::together : BandVerdict::apart;
      }};
      const auto& parts = partition.part({0, 64}, equal_shares(), most, rays);
      CHECK(parts.size() <= most);
      CHECK(2 * parts.size() >
            std::min<std::size_t>(most, 64 / static_cast<std::size_t>(largest_shared)));
      CHECK(covers(parts, {0, 64}));
      for (const BandPart& part : parts)
        CHECK((part.kind == BandPart::Kind::represented) == (part.bands.size() > largest_shared));
    }
}

// Of eight bands in three parts at most, the first half may be halved again, and then no other.
TEST_CASE("what cannot be halved any more is represented by one of its bands") {
  BandPartition partition;
  Rays rays{always_apart};
  const auto& parts = partition.part({0, 8}, equal_shares(), 3, rays);
  REQUIRE(parts.size() == 3);
  const int borders[3][2] = {{4, 8}, {0, 2}, {2, 4}};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(parts[i].kind == BandPart::Kind::represented);
    CHECK(parts[i].bands.first == borders[i][0]);
    CHECK(parts[i].bands.last == borders[i][1]);
  }
}

TEST_CASE("what is stopped is no part, and takes no other's place") {
  BandPartition partition;
  Rays rays{[](BandRange range) {
    if (range.first >= 32) return BandVerdict::stopped;
    return always_apart(range);
  }};
  const auto& parts = partition.part({0, 64}, equal_shares(), 32, rays);
  CHECK(parts.size() == 32);
  CHECK(covers(parts, {0, 32}));
}

TEST_CASE("ranges are halved by the bands' shares") {
  std::vector<double> seen(64, 0.0);
  for (std::size_t b = 48; b < 64; ++b)
    seen[b] = 1.0;
  BandPartition partition;
  Rays rays{
      [](BandRange r) { return r.size() == 64 ? BandVerdict::apart : BandVerdict::together; }};
  const auto& parts = partition.part({0, 64}, BandShares(seen), 64, rays);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].bands.last == 56); // half of what is seen lies before
}
