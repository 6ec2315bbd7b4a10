#include "spectral/gamut.h"
#include "tests/catch.h"

#include <algorithm>

using namespace abbe;

namespace {

bool inside(const LinearRgb& c) {
  return std::min({c.r, c.g, c.b}) >= 0.0 && std::max({c.r, c.g, c.b}) <= 1.0;
}

} // namespace

TEST_CASE("A colour inside the gamut is not touched") {
  for (const LinearRgb c : {LinearRgb{0, 0, 0}, {1, 1, 1}, {0.2, 1.0, 0.0}, {0.1, 0.5, 0.7}}) {
    CHECK(map_to_gamut(c, GamutMapping::clip) == c);
    CHECK(map_to_gamut(c, GamutMapping::desaturate) == c);
  }
}

TEST_CASE("Clip limits each component by itself") {
  CHECK(map_to_gamut({-0.5, 0.25, 3.0}, GamutMapping::clip) == LinearRgb{0.0, 0.25, 1.0});
}

TEST_CASE("Desaturate keeps luminance and the direction from grey") {
  for (const LinearRgb c :
       {LinearRgb{-0.4, 0.6, 0.2}, {1.8, 0.3, -0.1}, {0.1, 0.1, 4.0}, {0.9, -0.1, 1.3}}) {
    const LinearRgb mapped = map_to_gamut(c, GamutMapping::desaturate);
    const double y = luminance(c);
    REQUIRE((y > 0.0 && y < 1.0));
    CHECK(inside(mapped));
    CHECK(luminance(mapped) == Approx(y).epsilon(1e-14));
    // The same t for each component, and one component on the border: no more was given up.
    const double t = (mapped.r - y) / (c.r - y);
    CHECK((mapped.g - y) / (c.g - y) == Approx(t).epsilon(1e-12));
    CHECK((mapped.b - y) / (c.b - y) == Approx(t).epsilon(1e-12));
    CHECK((std::min({mapped.r, mapped.g, mapped.b}) < 1e-15 ||
           std::max({mapped.r, mapped.g, mapped.b}) > 1.0 - 1e-15));
  }
}

TEST_CASE("Too bright becomes white, no light becomes black") {
  CHECK(map_to_gamut({5, 1, 0}, GamutMapping::desaturate) == LinearRgb{1, 1, 1});
  CHECK(map_to_gamut({0.1, -0.5, 0.1}, GamutMapping::desaturate) == LinearRgb{0, 0, 0});
  CHECK(map_to_gamut({-0.5, -0.5, -0.5}, GamutMapping::desaturate) == LinearRgb{0, 0, 0});
}
