#include "core/plan/texture_plan.h"

#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <array>

using namespace abbe;

namespace {

std::vector<double> centers() {
  std::vector<double> nm;
  for (int b = 0; b < 81; ++b)
    nm.push_back(380.0 + 5.0 * b);
  return nm;
}

/// Of a texture of two constants: the value at a place.
float value(const Texture& texture, double u, double v) {
  TexturePlans plans;
  const int index = plan_texture(plans, texture, {}, centers(), true);
  BandTable scratch(0.0f, 81);
  const BandTable& table = texture_at(plans, index, {u, v}, scratch);
  REQUIRE(table.constant());
  return *table.constant();
}

/// What D65 makes of a reflectance, relative to the perfect reflector.
LinearRgb seen(const BandTable& reflectance) {
  const auto weights = band_weights(BandGrid(81), *find_illuminant("D65"));
  Xyz color{0, 0, 0}, white{0, 0, 0};
  for (int b = 0; b < 81; ++b) {
    const Xyz& w = weights[static_cast<std::size_t>(b)];
    const auto r = static_cast<double>(reflectance[b]);
    color.x += r * w.x, color.y += r * w.y, color.z += r * w.z;
    white.x += w.x, white.y += w.y, white.z += w.z;
  }
  const LinearRgb rgb = to_linear_srgb(color), full = to_linear_srgb(white);
  return {rgb.r / full.r, rgb.g / full.g, rgb.b / full.b};
}

/// Two by two: red, green above, blue, white below, but none is pure.
const ReflectanceImage kFour{
    2, 2, {0.8f, 0.1f, 0.05f, 0.2f, 0.7f, 0.1f, 0.1f, 0.2f, 0.6f, 0.9f, 0.9f, 0.9f}};

} // namespace

TEST_CASE("checker: fields in turn, the first at the origin, and on beyond 0 and 1") {
  const CheckerTexture checker{4, 2, Curve::constant(0.75), Curve::constant(0.25)};
  for (int i = -5; i < 9; ++i)
    for (int j = -5; j < 7; ++j) {
      const bool first = (i + j + 10) % 2 == 0;
      CHECK(value(checker, (i + 0.1) / 4, (j + 0.9) / 2) == (first ? 0.75f : 0.25f));
    }
}

TEST_CASE("grid: half of a line lies on each side of a border") {
  const GridTexture grid{10, 5, 0.25, Curve::constant(0.125), Curve::constant(0.875)};
  for (const double whole : {-3.0, 0.0, 1.0, 10.0}) {
    CHECK(value(grid, (whole + 0.12) / 10, 0.1) == 0.125f);
    CHECK(value(grid, (whole - 0.12) / 10, 0.1) == 0.125f);
    CHECK(value(grid, (whole + 0.13) / 10, 0.1) == 0.875f);
    CHECK(value(grid, (whole - 0.13) / 10, 0.1) == 0.875f);
    CHECK(value(grid, 0.05, (whole + 0.12) / 5) == 0.125f);
    CHECK(value(grid, 0.05, (whole - 0.13) / 5) == 0.875f);
  }
}

TEST_CASE("a field's reflectance may vary with wavelength") {
  const Curve slope = Curve::table({380, 780}, {0.0, 1.0});
  TexturePlans plans;
  const int index =
      plan_texture(plans, CheckerTexture{2, 2, slope, Curve::constant(0.5)}, {}, centers(), true);
  BandTable scratch(0.0f, 81);
  CHECK(texture_at(plans, index, {0.2, 0.2}, scratch)[40] == Approx(0.5));
  CHECK(texture_at(plans, index, {0.2, 0.2}, scratch)[60] == Approx(0.75));
  CHECK(texture_at(plans, index, {0.7, 0.2}, scratch).constant() == 0.5f);
}

TEST_CASE("image: upright, linear between the texels' centres, held outside them") {
  const auto check = [](double u, double v, double r, double g, double b) {
    const auto rgb = color_at(kFour, {u, v});
    CHECK(rgb[0] == Approx(r));
    CHECK(rgb[1] == Approx(g));
    CHECK(rgb[2] == Approx(b));
  };
  check(0.25, 0.75, 0.8, 0.1, 0.05);
  check(0.75, 0.75, 0.2, 0.7, 0.1);
  check(0.25, 0.25, 0.1, 0.2, 0.6);
  check(0.75, 0.25, 0.9, 0.9, 0.9);
  check(0.01, 0.99, 0.8, 0.1, 0.05); // the corner
  check(0.99, 0.0, 0.9, 0.9, 0.9);
  check(0.5, 0.9, 0.5, 0.4, 0.075);
  check(0.5, 0.5, 0.5, 0.475, 0.4125);
  check(0.25, 0.5 + 0.125, 0.75 * 0.8 + 0.25 * 0.1, 0.75 * 0.1 + 0.25 * 0.2,
        0.75 * 0.05 + 0.25 * 0.6);
  check(3.25, -0.25, 0.8, 0.1, 0.05); // repeated
}

TEST_CASE("an image's reflectances have its colours under D65, and lie between 0 and 1") {
  TexturePlans plans;
  const int index = plan_texture(plans, ImageTexture{0}, {kFour}, centers(), true);
  BandTable scratch(0.0f, 81);
  for (const dvec2 uv : {dvec2(0.25, 0.75), dvec2(0.75, 0.75), dvec2(0.25, 0.25), dvec2(0.5, 0.5),
                         dvec2(0.33, 0.61), dvec2(0.6, 0.3)}) {
    const auto rgb = color_at(kFour, uv);
    const BandTable& table = texture_at(plans, index, uv, scratch);
    for (int b = 0; b < 81; ++b)
      CHECK((table[b] >= 0.0f && table[b] <= 1.0f + 1e-6f));
    // Single precision sums a few products; to_linear_srgb has coefficients up to 3.2.
    const LinearRgb color = seen(table);
    CHECK(color.r == Approx(static_cast<double>(rgb[0])).margin(3e-6));
    CHECK(color.g == Approx(static_cast<double>(rgb[1])).margin(3e-6));
    CHECK(color.b == Approx(static_cast<double>(rgb[2])).margin(3e-6));
  }
}

TEST_CASE("whichever component is largest, a reflectance has its colour and lies between 0 and 1") {
  const ReflectanceLattice lattice(centers());
  BandTable table(0.0f, 81);
  constexpr std::array<float, 3> kOrder{0.0f, 0.3f, 0.9f};
  for (const float cell : {0.0f, 0.4f, 0.875f})
    for (const auto& [i, j, k] :
         {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
      const std::array<float, 3> rgb{cell + kOrder[static_cast<std::size_t>(i)] / 8.0f,
                                     cell + kOrder[static_cast<std::size_t>(j)] / 8.0f,
                                     cell + kOrder[static_cast<std::size_t>(k)] / 8.0f};
      lattice.evaluate(rgb, table);
      for (int b = 0; b < 81; ++b)
        CHECK((table[b] >= -1e-6f && table[b] <= 1.0f + 1e-6f));
      const LinearRgb color = seen(table);
      CHECK(color.r == Approx(static_cast<double>(rgb[0])).margin(3e-6));
      CHECK(color.g == Approx(static_cast<double>(rgb[1])).margin(3e-6));
      CHECK(color.b == Approx(static_cast<double>(rgb[2])).margin(3e-6));
    }
}

TEST_CASE("the lattice meets the corners of the colour cube, and greys are flat") {
  const ReflectanceLattice lattice(centers());
  BandTable table(0.0f, 81);
  for (const float r : {0.0f, 1.0f})
    for (const float g : {0.0f, 1.0f})
      for (const float b : {0.0f, 1.0f}) {
        lattice.evaluate({r, g, b}, table);
        const LinearRgb color = seen(table);
        CHECK(color.r == Approx(static_cast<double>(r)).margin(3e-6));
        CHECK(color.g == Approx(static_cast<double>(g)).margin(3e-6));
        CHECK(color.b == Approx(static_cast<double>(b)).margin(3e-6));
      }
  for (const float grey : {0.0f, 0.03f, 0.5f, 0.77f, 1.0f}) {
    lattice.evaluate({grey, grey, grey}, table);
    for (int b = 0; b < 81; ++b)
      CHECK(table[b] == Approx(grey).margin(1e-6));
  }
}
