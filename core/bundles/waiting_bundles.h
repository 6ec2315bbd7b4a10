#pragma once

#include "core/bands/band_span.h"
#include "core/bundles/bundle.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace abbe {

/// A bundle and what its bands carry.
struct CarriedBundle {
  Bundle bundle;
  std::vector<float> row; ///< Plan::stride values, of which those of the bundle's bands are valid

  explicit CarriedBundle(std::size_t stride) : row(stride) {}

  [[nodiscard]] BandSpan<float> throughput() { return {row.data(), bundle.bands}; }
};

/// Bundles that wait for their turn. The last to come is the first to go on. Bundles are handed
/// over by exchanging places, so nothing of them is copied.
class WaitingBundles {
public:
  /// `stride` is the length of a row of throughput.
  explicit WaitingBundles(std::size_t stride) : stride_(stride) {}

  /// A new bundle that waits, for these bands. All else, its throughput too, is the caller's to
  /// fill; what was there before is of no use. It stays in place until it is taken.
  [[nodiscard]] CarriedBundle& add(BandRange bands) {
    CarriedBundle& carried = *room();
    ++count_;
    carried.bundle.bands = bands;
    return carried;
  }
  /// Lets the caller's bundle wait; what the caller has then is of no use.
  void put(std::unique_ptr<CarriedBundle>& carried) {
    std::swap(carried, room());
    ++count_;
  }
  /// Hands over the bundle that came last. False when none waits.
  [[nodiscard]] bool take(std::unique_ptr<CarriedBundle>& carried) {
    if (count_ == 0) return false;
    std::swap(carried, places_[--count_]);
    return true;
  }

  /// Lets none wait any more.
  void clear() { count_ = 0; }

  [[nodiscard]] std::size_t size() const { return count_; }

private:
  [[nodiscard]] std::unique_ptr<CarriedBundle>& room() {
    if (places_.size() == count_) places_.push_back(std::make_unique<CarriedBundle>(stride_));
    return places_[count_];
  }

  std::size_t stride_;
  std::size_t count_ = 0;
  std::vector<std::unique_ptr<CarriedBundle>> places_; ///< the first `count_` wait
};

} // namespace abbe
