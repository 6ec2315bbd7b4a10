#include "core/bands/band_span.h"
#include "tests/catch.h"

#include <type_traits>

using namespace abbe;

TEST_CASE("a span of bands is indexed by band, not from its first band") {
  float values[4] = {0.0f, 1.0f, 2.0f, 3.0f};
  const BandSpan<float> span{values, {1, 3}};
  CHECK(span[1] == 1.0f);
  CHECK(&span[2] == &values[2]);
  span[2] = 7.0f;
  CHECK(values[2] == 7.0f);
}

TEST_CASE("a part of a span has the same values at the same bands") {
  float values[4] = {0.0f, 1.0f, 2.0f, 3.0f};
  const BandSpan<const float> part = BandSpan<float>{values, {0, 4}}.of({2, 4});
  CHECK(part.bands.first == 2);
  CHECK(part.bands.last == 4);
  CHECK(&part[3] == &values[3]);
}

TEST_CASE("a span of values converts to one of constant values, but not the reverse") {
  CHECK(std::is_convertible_v<BandSpan<float>, BandSpan<const float>>);
  CHECK_FALSE(std::is_convertible_v<BandSpan<const float>, BandSpan<float>>);
}
