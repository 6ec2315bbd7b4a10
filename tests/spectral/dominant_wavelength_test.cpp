#include "spectral/dominant_wavelength.h"

#include "spectral/line_lamp.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

constexpr Chromaticity kEqualEnergy{1.0 / 3.0, 1.0 / 3.0};

/// The chromaticity of a mixture of a light with white, by parts of x, y.
Chromaticity mixed(const Chromaticity& light, const Chromaticity& white, double part) {
  return {white.x + part * (light.x - white.x), white.y + part * (light.y - white.y)};
}

} // namespace

TEST_CASE("light of one wavelength has this wavelength and a purity of 1") {
  for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const double nm : {450.0, 486.1, 532.4, 555.0, 587.56, 589.29, 632.8}) {
      INFO(nm);
      const Chromaticity light = chromaticity(to_xyz(line_lamp(nm), observer));
      const auto found = dominant_wavelength(light, kSrgbWhite, observer);
      REQUIRE(found);
      CHECK(found->nm == Approx(nm).margin(0.03));
      CHECK(found->purity == Approx(1.0).margin(1e-6));
      CHECK_FALSE(found->complementary);
    }
}

TEST_CASE("white light that is added changes purity alone") {
  for (const double nm : {480.0, 550.0, 600.0})
    for (const double part : {0.9, 0.3, 0.01}) {
      const Chromaticity light = chromaticity(to_xyz(line_lamp(nm)));
      const auto found = dominant_wavelength(mixed(light, kEqualEnergy, part), kEqualEnergy);
      REQUIRE(found);
      CHECK(found->nm == Approx(nm).margin(1e-6));
      CHECK(found->purity == Approx(part).epsilon(1e-9));
    }
}

TEST_CASE("a published colour has its published dominant wavelength") {
  // 616 nm, where the boundary has x, y = 0.68354746, 0.31628409 (colour-science 0.3, README).
  const auto found = dominant_wavelength({0.54369557, 0.32107944}, kSrgbWhite);
  REQUIRE(found);
  CHECK(found->nm == Approx(616.0).margin(0.5));
  CHECK(found->purity == Approx((0.54369557 - 0.3127) / (0.68354746 - 0.3127)).margin(2e-3));
}

TEST_CASE("a purple has the wavelength that makes it white") {
  // The colour lies opposite to 520 nm, seen from white.
  const Chromaticity green = chromaticity(to_xyz(line_lamp(520.0)));
  const auto found = dominant_wavelength(mixed(green, kEqualEnergy, -0.2), kEqualEnergy);
  REQUIRE(found);
  CHECK(found->complementary);
  CHECK(found->nm == Approx(520.0).margin(1e-6));
  CHECK(found->purity > 0.0);
  CHECK(found->purity < 1.0);
  // On the line from 780 to 380 nm, purity is 1.
  const Chromaticity red = chromaticity(to_xyz(line_lamp(780.0)));
  const Chromaticity violet = chromaticity(to_xyz(line_lamp(380.0)));
  const auto line = dominant_wavelength(mixed(red, violet, 0.5), kEqualEnergy);
  REQUIRE(line);
  CHECK(line->complementary);
  CHECK(line->purity == Approx(1.0).margin(1e-9));
}

TEST_CASE("white has no dominant wavelength") {
  CHECK_FALSE(dominant_wavelength(kSrgbWhite, kSrgbWhite));
}
