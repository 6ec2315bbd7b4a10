#pragma once

#include "core/bands/band_shares.h"

#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace abbe {

/// What rays tell about a range of bands.
enum class BandVerdict {
  stopped,  ///< none of its bands goes on
  together, ///< its bands may share a ray; so may a single band with itself
  apart     ///< its bands should have rays of their own
};

/// A range of bands that goes on, and how.
struct BandPart {
  enum class Kind {
    single,     ///< it is one band
    shared,     ///< its bands share a ray
    represented ///< one of its bands goes on for all: there are too many parts to halve it again
  };
  BandRange bands;
  Kind kind;
};

/// Rays that decide a partition: `prepare` is told the ranges that will be judged next, so that
/// rays may be traced together.
template <class Rays>
concept BandRays = requires(Rays& rays, std::span<const BandRange> ranges, BandRange range) {
  rays.prepare(ranges);
  { rays.judge(range) } -> std::same_as<BandVerdict>;
};

/// Parts ranges of bands, in scenes and in a camera's lens. It keeps its memory from one partition
/// to the next.
class BandPartition {
public:
  /// Halves ranges of bands by their shares, all of one size before the next smaller, until the
  /// rays say of each that its bands may go on together, or until there are `most` parts. The
  /// parts are valid until the next call.
  template <BandRays Rays>
  const std::vector<BandPart>& part(BandRange whole, const BandShares& shares, std::size_t most,
                                    Rays&& rays) {
    parts_.clear();
    ranges_.assign(1, whole);
    while (!ranges_.empty()) {
      rays.prepare(std::span<const BandRange>(ranges_));
      next_ranges_.clear();
      std::size_t waiting = ranges_.size();
      for (const BandRange& range : ranges_) {
        --waiting;
        const BandVerdict verdict = rays.judge(range);
        if (verdict == BandVerdict::stopped) continue;
        if (range.size() == 1) {
          parts_.push_back({range, BandPart::Kind::single});
        } else if (verdict == BandVerdict::together) {
          parts_.push_back({range, BandPart::Kind::shared});
        } else if (parts_.size() + next_ranges_.size() + waiting + 2 > most) {
          parts_.push_back({range, BandPart::Kind::represented});
        } else {
          const int middle = shares.middle(range);
          next_ranges_.push_back({range.first, middle});
          next_ranges_.push_back({middle, range.last});
        }
      }
      std::swap(ranges_, next_ranges_);
    }
    return parts_;
  }

private:
  std::vector<BandPart> parts_;
  std::vector<BandRange> ranges_, next_ranges_; ///< of this round, and of the next
};

} // namespace abbe
