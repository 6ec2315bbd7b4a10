#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace abbe;

namespace {

const Curve& d65() {
  static const Curve curve = *find_illuminant("D65");
  return curve;
}

// Linear sRGB of a light as shares of that of D65.
LinearRgb relative_rgb(const Curve& light) {
  const LinearRgb rgb = to_linear_srgb(to_xyz(light));
  const LinearRgb white = to_linear_srgb(to_xyz(d65()));
  return {rgb.r / white.r, rgb.g / white.g, rgb.b / white.b};
}

double distance(const LinearRgb& a, const LinearRgb& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// Error of the reflectance made for a colour; also checks that it is one.
double reflectance_error(const LinearRgb& color) {
  const Curve curve = rgb_reflectance(color);
  for (int k = 0; k < kSampleCount; ++k) {
    const double value = curve.at(sample_nm(k));
    if (!(value >= 0.0 && value <= 1.0)) return INFINITY;
  }
  return distance(relative_rgb(d65().times(curve)), color);
}

} // namespace

TEST_CASE("Greys are exact constants") {
  for (const double g : {0.0, 0.18, 0.5, 1.0}) {
    CHECK(rgb_reflectance({g, g, g}) == Curve::constant(g));
  }
  CHECK(rgb_reflectance({2, 3, 4}) == Curve::constant(1.0));
  CHECK(rgb_reflectance({-1, -2, 0}) == Curve::constant(0.0));
  CHECK(rgb_emission({0, 0, 0}) == Curve::constant(0.0));
  CHECK(rgb_emission({-1, -2, -3}) == Curve::constant(0.0));
}

TEST_CASE("White emission is D65, grey emission a multiple of it") {
  CHECK(rgb_emission({1, 1, 1}) == d65());
  CHECK(rgb_emission({8, 8, 8}) == d65().scaled(8.0));
}

TEST_CASE("A reflectance has its colour all over the cube, corners included") {
  constexpr int kSteps = 10;
  double worst = 0.0;
  for (int r = 0; r <= kSteps; ++r)
    for (int g = 0; g <= kSteps; ++g)
      for (int b = 0; b <= kSteps; ++b)
        worst = std::max(worst, reflectance_error({r / 10.0, g / 10.0, b / 10.0}));
  CHECK(worst < 1e-11);
}

TEST_CASE("Dark, bright and nearly grey colours converge too") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const auto dark = [&] { return std::pow(10.0, -20.0 * uniform(random)); };
    const LinearRgb c{dark(), dark(), dark()};
    worst = std::max(worst, reflectance_error(c));
    worst = std::max(worst, reflectance_error({1.0 - c.r, 1.0 - c.g, 1.0 - c.b}));
    worst = std::max(worst, reflectance_error({0.5 + 1e-3 * c.r, 0.5 - 1e-3 * c.g, 0.5}));
    worst = std::max(worst, reflectance_error({c.r, 1.0 - c.g, i % 2 ? c.b : 1.0 - c.b}));
  }
  CHECK(worst < 1e-11);
  CHECK(reflectance_error({5e-324, 0.0, 0.0}) < 1e-11);
  CHECK(reflectance_error({1.0, 1.0, std::nextafter(1.0, 0.0)}) < 1e-11);
}

TEST_CASE("Colours out of range are clamped") {
  CHECK(rgb_reflectance({1.5, -0.2, 0.3}) == rgb_reflectance({1.0, 0.0, 0.3}));
  CHECK(rgb_emission({1.5, -0.2, 0.3}) == rgb_emission({1.5, 0.0, 0.3}));
}

TEST_CASE("An emission has its colour at any strength, and scales with it") {
  for (const LinearRgb c :
       {LinearRgb{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0.01, 0}, {0.3, 40, 20}}) {
    const double peak = std::max({c.r, c.g, c.b});
    CHECK(distance(relative_rgb(rgb_emission(c)), c) < 1e-10 * peak);
    CHECK(rgb_emission({8 * c.r, 8 * c.g, 8 * c.b}) == rgb_emission(c).scaled(8.0));
  }
}

TEST_CASE("Ordinary colours are smooth: no step between samples is large") {
  for (const LinearRgb c : {LinearRgb{0.6, 0.2, 0.2}, {0.2, 0.5, 0.3}, {0.2, 0.3, 0.7}}) {
    const Curve curve = rgb_reflectance(c);
    for (int k = 1; k < kSampleCount; ++k)
      CHECK(std::abs(curve.at(sample_nm(k)) - curve.at(sample_nm(k - 1))) < 0.05);
  }
}
