#pragma once

#include "core/bands/band_range.h"

#include <type_traits>

namespace abbe {

/// The values of a range of bands. `data` points to the value of band 0, not to that of the range's
/// first band, so that it is indexed by band; only bands of the range may be used. Behind `data`
/// lies a whole padded array, as in a BandTable.
template <class T>
struct BandSpan {
  T* data = nullptr;
  BandRange bands;

  [[nodiscard]] T& operator[](int band) const { return data[band]; }
  /// The same array for another range, usually a part of this one.
  [[nodiscard]] BandSpan of(BandRange range) const { return {data, range}; }

  operator BandSpan<const T>() const
    requires(!std::is_const_v<T>)
  {
    return {data, bands};
  }
};

} // namespace abbe
