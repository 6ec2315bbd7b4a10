#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kPixels = 480;
constexpr double kMiddle = 46.0, kView = 20.0; // degrees; a pixel is about 0.04 degrees

/// A column of pixels across the bows, through rain, the sun at the horizon behind the camera. The
/// camera looks up by kMiddle degrees.
Film column(const std::string& drops) {
  const double a = kMiddle * kDegree;
  const Scene scene = test::scene_from(
      "unit m eye 0 0 0 lookAt 0 " + std::to_string(std::sin(a)) + " " +
      std::to_string(-std::cos(a)) + " fieldOfView " + std::to_string(kView) + " imageSize 1 " +
      std::to_string(kPixels) + " samples 4 filter box light E 0 0 1 0 " + drops +
      " push translate 0 0 -200 scale 1000 1000 100 cube pop");
  Rendering r = test::render_scene(scene, true);
  return std::move(r.film);
}

/// The angle from the antisolar point at which a pixel's centre looks.
double radius_deg(int y) {
  const double up = (1.0 - (y + 0.5) * 2.0 / kPixels) * std::tan(0.5 * kView * kDegree);
  return kMiddle + std::atan(up) / kDegree;
}

/// The angle between two others at which a band is brightest.
double brightest_deg(const Film& film, int band, double from, double to) {
  int best = -1;
  for (int y = 0; y < kPixels; ++y)
    if (radius_deg(y) > from && radius_deg(y) < to &&
        (best < 0 || film.radiance(0, y, band) > film.radiance(0, best, band)))
      best = y;
  return radius_deg(best);
}

double radiance_at(const Film& film, int band, double radius) {
  int nearest = 0;
  for (int y = 0; y < kPixels; ++y)
    if (std::abs(radius_deg(y) - radius) < std::abs(radius_deg(nearest) - radius)) nearest = y;
  return film.radiance(0, nearest, band);
}

int band_at(double nm) {
  return static_cast<int>((nm - 377.5) / 5.0);
}

} // namespace

// Descartes: 42.36 and 50.39 degrees for red water, n = 1.3311; 40.58 and 53.61 for violet, 1.3435.
TEST_CASE("bows of a forced index stand in the image where Descartes has them") {
  const Film red = column("drops 1e-6 dropSun 0 dropIndex 1.3311");
  const Film violet = column("drops 1e-6 dropSun 0 dropIndex 1.3435");
  for (const int band : {0, 40, 80}) {
    CHECK(brightest_deg(red, band, 38.0, 46.0) == Approx(42.36).margin(0.1));
    CHECK(brightest_deg(red, band, 46.0, 55.0) == Approx(50.39).margin(0.1));
    CHECK(brightest_deg(violet, band, 38.0, 46.0) == Approx(40.58).margin(0.1));
    CHECK(brightest_deg(violet, band, 46.0, 55.0) == Approx(53.61).margin(0.1));
  }
}

TEST_CASE("water under the sun's disc has red outside the primary and inside the secondary") {
  const Film film = column("drops 1e-6");
  const int violet = band_at(420.0), green = band_at(530.0), red = band_at(650.0);
  const auto primary = [&](int band) { return brightest_deg(film, band, 38.0, 46.0); };
  const auto secondary = [&](int band) { return brightest_deg(film, band, 46.0, 55.5); };
  CHECK(primary(violet) + 0.4 < primary(green));
  CHECK(primary(green) + 0.4 < primary(red));
  CHECK(secondary(red) + 0.7 < secondary(green));
  CHECK(secondary(green) + 0.7 < secondary(violet));
  for (const int band : {violet, green, red}) {
    // Alexander's band is darker than the sky on either side of the bows.
    const double dark = radiance_at(film, band, 46.5);
    CHECK(radiance_at(film, band, 38.0) > 10.0 * dark);
    CHECK(radiance_at(film, band, 55.5) > 2.0 * dark);
    CHECK(radiance_at(film, band, primary(band)) > 3.0 * radiance_at(film, band, secondary(band)));
  }
}
