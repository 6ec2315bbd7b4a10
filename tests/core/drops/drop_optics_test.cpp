#include "core/drops/drop_optics.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180.0;

double radius_deg(double n, int order) {
  return 180.0 - bow_angle(n, order).value() / kDegree;
}

std::vector<double> flux(double n, int first_order, int last_order, std::size_t cells) {
  std::vector<double> result(cells);
  add_drop_flux(n, first_order, last_order, result);
  return result;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The share of light at the impact parameter b, by Fresnel's equations in sines and tangents.
double share_at(double n, int order, double b) {
  const double i = std::asin(b), r = std::asin(b / n);
  const double s = std::pow(std::sin(i - r) / std::sin(i + r), 2);
  const double p = std::pow(std::tan(i - r) / std::tan(i + r), 2);
  const auto left = [&](double R) {
    return order == 0 ? R : (1.0 - R) * (1.0 - R) * std::pow(R, order - 1);
  };
  return 0.5 * (left(s) + left(p));
}

/// The ray at the impact parameter b, drawn in the plane: the cosine of the angle between the way
/// it comes and the way it leaves a circle of radius 1.
double traced_cosine(double n, int order, double b) {
  using glm::dvec2;
  const auto refracted = [](const dvec2& d, const dvec2& facing, double eta) {
    const double c = -glm::dot(d, facing);
    return glm::normalize(d / eta +
                          (c / eta - std::sqrt(1.0 - (1.0 - c * c) / (eta * eta))) * facing);
  };
  const auto mirrored = [](const dvec2& d, const dvec2& m) { return d - 2.0 * glm::dot(d, m) * m; };
  dvec2 direction(1.0, 0.0), place(-std::sqrt(1.0 - b * b), b);
  if (order == 0) return mirrored(direction, place).x;
  direction = refracted(direction, place, n);
  for (int chord = 1;; ++chord) {
    place -= 2.0 * glm::dot(place, direction) * direction;
    place = glm::normalize(place);
    if (chord == order) return refracted(direction, -place, 1.0 / n).x;
    direction = mirrored(direction, place);
  }
}

constexpr int kRays = 400000;

/// Impact parameters in the middle of rings of equal area.
double impact(int ray) {
  return std::sqrt((ray + 0.5) / kRays);
}

} // namespace

// Descartes' rays, cos^2 i = (n^2 - 1) / 3 and (n^2 - 1) / 8.
TEST_CASE("the bows stand where Descartes has them") {
  CHECK(radius_deg(1.3311, 2) == Approx(42.355).margin(5e-4));
  CHECK(radius_deg(1.3435, 2) == Approx(40.575).margin(5e-4));
  CHECK(radius_deg(1.3311, 3) == Approx(50.392).margin(5e-4));
  CHECK(radius_deg(1.3435, 3) == Approx(53.605).margin(5e-4));
  CHECK(radius_deg(4.0 / 3.0, 2) == Approx(42.030).margin(5e-4));
  CHECK(radius_deg(4.0 / 3.0, 3) == Approx(50.978).margin(5e-4));
}

TEST_CASE("there is no bow without an inner reflection, and no primary at n = 2 and above") {
  CHECK_FALSE(bow_angle(1.33, 0));
  CHECK_FALSE(bow_angle(1.33, 1));
  CHECK_FALSE(bow_angle(2.0, 2));
  CHECK(bow_angle(2.0, 3));
}

TEST_CASE("a ray drawn through the drop leaves at its deviation") {
  for (const double n : {1.0, 1.3311, 1.3435, 2.4})
    for (int order = 0; order <= 7; ++order)
      for (const double b : {0.0, 0.2, 0.7, 0.86, 0.95, 0.999}) {
        INFO("n " << n << " order " << order << " b " << b);
        CHECK(std::cos(drop_deviation(n, order, std::asin(b))) ==
              Approx(traced_cosine(n, order, b)).margin(1e-10));
      }
}

TEST_CASE("each order has the flux of its polarisations, integrated over the drop's disc") {
  for (const double n : {1.3311, 1.3435})
    for (int order = 0; order <= 7; ++order) {
      double expected = 0.0;
      for (int ray = 0; ray < kRays; ++ray)
        expected += share_at(n, order, impact(ray)) / kRays;
      INFO("n " << n << " order " << order);
      CHECK(sum(flux(n, order, order, 180)) == Approx(expected).epsilon(1e-5));
    }
}

// A ring of the disc is a ray here, so a cell's border may be missed by a ring or two.
TEST_CASE("each cell has the flux of the rays that leave into it") {
  constexpr std::size_t kCells = 90;
  for (int order = 0; order <= 4; ++order) {
    const std::vector<double> cells = flux(1.3343, order, order, kCells);
    std::vector<double> expected(kCells);
    for (int ray = 0; ray < kRays; ++ray) {
      const double b = impact(ray);
      const double angle = std::acos(std::clamp(traced_cosine(1.3343, order, b), -1.0, 1.0));
      expected[std::min(static_cast<std::size_t>(angle / kPi * kCells), kCells - 1)] +=
          share_at(1.3343, order, b) / kRays;
    }
    for (std::size_t j = 0; j < kCells; ++j) {
      INFO("order " << order << " cell " << j);
      CHECK(cells[j] == Approx(expected[j]).margin(4.0 / kRays));
    }
  }
}

TEST_CASE("no light is lost: all orders and the remainder make 1") {
  for (const double n : {1.0001, 1.3311, 1.3435, 1.5, 2.4})
    for (const int last_order : {1, 3, 12})
      CHECK(sum(flux(n, 0, last_order, 720)) + drop_remainder(n, last_order) ==
            Approx(1.0).epsilon(1e-8));
  CHECK(drop_remainder(1.3333, 12) < 1e-4);
}

TEST_CASE("a drop of no refraction lets all light straight on") {
  const std::vector<double> cells = flux(1.0, 0, 5, 36);
  CHECK(cells[0] == Approx(1.0).epsilon(1e-12));
  CHECK(sum(cells) == Approx(1.0).epsilon(1e-12));
}

// Cells of 0.01 degrees; a bow's first cell is its brightest.
TEST_CASE("the finest cells are brightest at the bows") {
  constexpr std::size_t kCells = 18000;
  const auto brightest_radius = [](double n, double from_deg, double to_deg) {
    const std::vector<double> cells = flux(n, 0, 12, kCells);
    const auto place = [&](double radius) {
      return cells.begin() + static_cast<std::ptrdiff_t>((180.0 - radius) * 100.0);
    };
    const auto peak = std::max_element(place(to_deg), place(from_deg));
    return 180.0 - (static_cast<double>(peak - cells.begin()) + 0.5) / 100.0;
  };
  CHECK(brightest_radius(1.3311, 30.0, 46.0) == Approx(42.36).margin(0.02));
  CHECK(brightest_radius(1.3435, 30.0, 46.0) == Approx(40.58).margin(0.02));
  CHECK(brightest_radius(1.3311, 46.0, 60.0) == Approx(50.39).margin(0.02));
  CHECK(brightest_radius(1.3435, 46.0, 60.0) == Approx(53.61).margin(0.02));
}

TEST_CASE("between the bows there is only what the outside reflects, and higher orders") {
  constexpr std::size_t kCells = 1800; // of 0.1 degrees
  for (int order = 0; order <= 3; ++order) {
    const std::vector<double> cells = flux(4.0 / 3.0, order, order, kCells);
    // The radii 42.1 to 50.9 are within 42.030 and 50.978.
    double dark = 0.0;
    for (std::size_t j = 1291; j < 1379; ++j)
      dark += cells[j];
    INFO("order " << order);
    if (order == 0)
      CHECK(dark > 1e-3);
    else
      CHECK(dark == 0.0);
  }
}
