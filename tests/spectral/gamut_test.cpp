#include "spectral/color_space.h"
#include "spectral/gamut.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>

using namespace abbe;

namespace {

LinearRgb map_srgb(const LinearRgb& color, GamutMapping mapping) {
  return map_to_gamut(color, mapping, srgb_luminance_weights());
}

bool inside(const LinearRgb& c) {
  return std::min({c.r, c.g, c.b}) >= 0.0 && std::max({c.r, c.g, c.b}) <= 1.0;
}

} // namespace

TEST_CASE("A colour inside the gamut is not touched") {
  for (const LinearRgb c : {LinearRgb{0, 0, 0}, {1, 1, 1}, {0.2, 1.0, 0.0}, {0.1, 0.5, 0.7}}) {
    CHECK(map_srgb(c, GamutMapping::clip) == c);
    CHECK(map_srgb(c, GamutMapping::scale) == c);
    CHECK(map_srgb(c, GamutMapping::desaturate) == c);
  }
}

TEST_CASE("Clip limits each component by itself") {
  CHECK(map_srgb({-0.5, 0.25, 3.0}, GamutMapping::clip) == LinearRgb{0.0, 0.25, 1.0});
}

TEST_CASE("Desaturate keeps luminance and the direction from grey") {
  for (const LinearRgb c :
       {LinearRgb{-0.4, 0.6, 0.2}, {1.8, 0.3, -0.1}, {0.1, 0.1, 4.0}, {0.9, -0.1, 1.3}}) {
    const LinearRgb mapped = map_srgb(c, GamutMapping::desaturate);
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
  CHECK(map_srgb({5, 1, 0}, GamutMapping::desaturate) == LinearRgb{1, 1, 1});
  CHECK(map_srgb({0.1, -0.5, 0.1}, GamutMapping::desaturate) == LinearRgb{0, 0, 0});
  CHECK(map_srgb({-0.5, -0.5, -0.5}, GamutMapping::desaturate) == LinearRgb{0, 0, 0});
}

TEST_CASE("Scale is the thesis's example: 0.4 -0.6 1.2 becomes 5/9 0 1") {
  const LinearRgb mapped = map_srgb({0.4, -0.6, 1.2}, GamutMapping::scale);
  CHECK(mapped.r == Approx(5.0 / 9.0).epsilon(1e-14));
  CHECK(mapped.g == 0.0);
  CHECK(mapped.b == 1.0);
}

TEST_CASE("Scale keeps order and hue angle, and touches only what is out of range") {
  const auto hue = [](const LinearRgb& c) {
    return std::atan2(std::sqrt(3.0) * (c.g - c.b), 2.0 * c.r - c.g - c.b);
  };
  for (const LinearRgb c :
       {LinearRgb{-0.4, 0.6, 0.2}, {1.8, 0.3, 0.1}, {0.1, 0.1, 4.0}, {0.9, -0.1, 1.3}}) {
    const LinearRgb mapped = map_srgb(c, GamutMapping::scale);
    CHECK(inside(mapped));
    CHECK(hue(mapped) == Approx(hue(c)).epsilon(1e-12));
  }
  // Nothing negative: only divided by the largest. Nothing above 1: the range is 1 - low.
  CHECK(map_srgb({2.0, 1.0, 0.0}, GamutMapping::scale) == LinearRgb{1.0, 0.5, 0.0});
  CHECK(map_srgb({-1.0, 1.0, 0.0}, GamutMapping::scale) == LinearRgb{0.0, 1.0, 0.5});
}

TEST_CASE("Desaturate keeps luminance and dominant wavelength of every spectral colour") {
  // On any display: the mapped chromaticity lies on the line from the display's white to the
  // colour.
  for (const char* name : {"srgb", "p3", "rec2020", "adobe-rgb", "ntsc", "p22"}) {
    const ColorSpace space = find_color_space(name).value();
    const Matrix3 to_xyz_of_rgb = rgb_to_xyz_matrix(space.primaries, space.white);
    const Matrix3 to_rgb = inverse(to_xyz_of_rgb);
    int mapped_count = 0;
    for (const Xyz& band : band_weights(BandGrid(81), Curve::constant(1.0))) {
      const double y = 0.3;
      const Chromaticity c = chromaticity(band);
      const Xyz color = to_xyz(c, y);
      const Vector3 rgb = multiply(to_rgb, Vector3{color.x, color.y, color.z});
      const LinearRgb mapped =
          map_to_gamut({rgb[0], rgb[1], rgb[2]}, GamutMapping::desaturate, to_xyz_of_rgb[1]);
      INFO(name << ' ' << c.x << ' ' << c.y);
      CHECK(inside(mapped));
      const Vector3 xyz = multiply(to_xyz_of_rgb, Vector3{mapped.r, mapped.g, mapped.b});
      CHECK(xyz[1] == Approx(y).epsilon(1e-12));
      const Chromaticity m = chromaticity({xyz[0], xyz[1], xyz[2]});
      const double across = (m.x - space.white.x) * (c.y - space.white.y) -
                            (m.y - space.white.y) * (c.x - space.white.x);
      const double along = (m.x - space.white.x) * (c.x - space.white.x) +
                           (m.y - space.white.y) * (c.y - space.white.y);
      CHECK(std::abs(across) < 1e-12);
      CHECK(along > 0.0);
      ++mapped_count;
    }
    CHECK(mapped_count == 81);
  }
}
