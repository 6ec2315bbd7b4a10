#include "io/selftest/expected_index.h"
#include "io/selftest/newton_rows.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

// Newton's spectrum as a camera sees it that looks straight at the wall: every pixel shows the same
// area of it, so sums over pixels are fluxes.

namespace {

constexpr double kDistance = 4.0, kMiddle = -3.08, kHeight = 2.2;
constexpr int kColumns = 6, kRows = 160;
constexpr double kPixel = kHeight / kRows; // on the wall
constexpr double kReflectance = 0.78;

/// Three surfaces at most: no light that was thrown back inside the prism reaches the wall.
Rendering wall_seen_straight_on() {
  const double view = 2.0 * std::atan(0.5 * kHeight / kDistance) * 180.0 / std::numbers::pi;
  Scene scene =
      test::scene_from(newton_scene() + "eye " + std::to_string(kNewtonWall - kDistance) + " " +
                       std::to_string(kMiddle) + " 0 lookAt " + std::to_string(kNewtonWall) + " " +
                       std::to_string(kMiddle) +
                       " 0 maxRecursionDepth 3 filter tent samples 1 lightPaths 136 jitter off");
  scene.camera.field_of_view_deg = view;
  scene.settings.width = kColumns;
  scene.settings.height = kRows;
  return test::render_scene(scene, true);
}

} // namespace

TEST_CASE("Newton's spectrum in the image: place, flux and colour of all bands") {
  const Rendering r = wall_seen_straight_on();
  const std::vector<Xyz> weights = band_weights(BandGrid(81), Curve::constant(1.0));
  // Radiance of a diffuse wall to irradiance, and that to flux of a pixel's area.
  const double to_flux = std::numbers::pi / kReflectance * kPixel * kPixel;
  double seen = 0.0, exact = 0.0, last_row = 0.0;
  Xyz seen_xyz{}, exact_xyz{}, film_xyz{};
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const NewtonArrival arrival = newton_arrival(catalogue_index("SF11", nm));
    double flux = 0.0, moment = 0.0;
    for (int y = 0; y < kRows; ++y)
      for (int x = 0; x < kColumns; ++x) {
        const double f = r.film.radiance(x, y, b) * to_flux;
        flux += f;
        moment += f * (y + 0.5);
      }
    const double row = 0.5 * kRows - (arrival.y - kMiddle) / kPixel;
    INFO(nm << " nm");
    CHECK(moment / flux == Approx(row).margin(0.5));
    if (b > 0) CHECK(std::abs(row - last_row) >= 0.3);
    last_row = row;
    const double expected = newton_beam() * arrival.transmittance;
    CHECK(flux == Approx(expected).epsilon(0.05)); // each band has a tenth of the paths
    seen += flux;
    exact += expected;
    const auto add = [&](Xyz& sum, double f) {
      sum.x += weights[static_cast<std::size_t>(b)].x * f;
      sum.y += weights[static_cast<std::size_t>(b)].y * f;
      sum.z += weights[static_cast<std::size_t>(b)].z * f;
    };
    add(seen_xyz, flux);
    add(exact_xyz, expected);
  }
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x) {
      const Xyz c = r.film.color(x, y);
      film_xyz.x += c.x * to_flux;
      film_xyz.y += c.y * to_flux;
      film_xyz.z += c.z * to_flux;
    }
  CHECK(seen == Approx(exact).epsilon(0.01));
  const auto x_of = [](const Xyz& c) { return c.x / (c.x + c.y + c.z); };
  const auto y_of = [](const Xyz& c) { return c.y / (c.x + c.y + c.z); };
  CHECK(x_of(seen_xyz) == Approx(x_of(exact_xyz)).margin(0.002));
  CHECK(y_of(seen_xyz) == Approx(y_of(exact_xyz)).margin(0.002));
  CHECK(film_xyz.y == Approx(exact_xyz.y).epsilon(0.01));
  CHECK(x_of(film_xyz) == Approx(x_of(exact_xyz)).margin(0.002));
  CHECK(y_of(film_xyz) == Approx(y_of(exact_xyz)).margin(0.002));
}
