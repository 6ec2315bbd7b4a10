#include "core/integrators/light_paths.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace abbe;

// Parallel light close to the axis of a lens meets a card. Each band's light crosses the axis where
// the lensmaker's formula for thick lenses has its focus: longitudinal chromatic aberration.

namespace {

struct Lens {
  double r1, r2, thickness; ///< r2 infinite: flat
};

/// From the front vertex to the focus.
double paraxial_focus(const Lens& lens, double n) {
  const double c1 = 1.0 / lens.r1, c2 = 1.0 / lens.r2, t = lens.thickness;
  const double power = (n - 1.0) * (c1 - c2 + (n - 1.0) * t * c1 * c2 / n);
  return t + (1.0 - (n - 1.0) * t * c1 / n) / power;
}

/// Where each band's photons on a card lie closest to the axis: the z at which the sum of their
/// squared distances from it is least.
std::array<double, 81> smallest_spots(const Lens& lens, const std::string& glass) {
  const auto number = [](double v) { return std::isinf(v) ? "inf" : std::to_string(v); };
  const Scene scene = test::scene_from(
      "integrator path jitter off light E 0 0 -1 0 glass " + glass + " lensElement " +
      number(lens.r1) + " " + number(lens.r2) + " " + number(lens.thickness) +
      " 20 defaultMaterials translate 0 0 12 scale 15 15 1 square");
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  Film film({0, 0, 1, 1}, 1.0, 0);
  const Emission emission(scene, plan);
  LightPaths paths(plan, world, emission, nullptr, film);
  PhotonBatch batch;
  RayCounts counts;
  constexpr std::uint32_t kPaths = 2000;
  constexpr double kHeight = 0.05; // spherical aberration is (height/focus)^2 of the focus: 1e-6
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPaths;
    EmittedRay ray;
    ray.state.ray = {{kHeight * std::cos(angle), kHeight * std::sin(angle), -5.0}, {0, 0, 1}};
    ray.source = plan.light_source(0);
    ray.flux = 1.0;
    paths.trace(ray, Sampler(0, 0, i, 1), 1.0, &batch, 1.0, counts);
  }
  std::array<double, 81> across{}, slopes{};
  for (const Photon& photon : batch.photons) {
    if (photon.direction.z < 0.5) continue;
    const glm::dvec2 slope = glm::dvec2(photon.direction) / photon.direction.z;
    const glm::dvec2 on_axis_plane = glm::dvec2(photon.position) - slope * photon.position.z;
    for (int b = photon.bands.first; b < photon.bands.last; ++b) {
      const auto i = static_cast<std::size_t>(b);
      // Light thrown back inside the lens lands on other places; it is fainter.
      const auto w = static_cast<double>(
          batch.flux[photon.flux + static_cast<std::size_t>(b - photon.bands.first)]);
      if (glm::length(slope) > 2.0 * kHeight / lens.r1) continue;
      across[i] -= w * glm::dot(on_axis_plane, slope);
      slopes[i] += w * glm::dot(slope, slope);
    }
  }
  std::array<double, 81> focus{};
  for (std::size_t b = 0; b < 81; ++b)
    focus[b] = across[b] / slopes[b];
  return focus;
}

/// Between two bands.
double at_nm(const std::array<double, 81>& focus, double nm) {
  const double place = (nm - 380.0) / 5.0;
  const auto b = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(b);
  return (1.0 - part) * focus[b] + part * focus[b + 1];
}

} // namespace

TEST_CASE("each band comes to its focus where the lensmaker's formula has it") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const std::string glass : {"N-SF11", "SF11", "N-BK7"})
    for (const Lens& lens : {Lens{39.24, infinite, 4.0}, Lens{60.0, -60.0, 5.0}}) {
      const auto focus = smallest_spots(lens, glass);
      const auto exact = [&](double nm) {
        return paraxial_focus(lens, refractive_index(find_glass(glass)->dispersion, nm));
      };
      for (int b = 0; b < 81; ++b) {
        INFO(glass << ", " << 380 + 5 * b << " nm, radius " << lens.r1);
        CHECK(focus[static_cast<std::size_t>(b)] == Approx(exact(380.0 + 5.0 * b)).epsilon(1e-4));
      }
      constexpr double kF = 486.1327, kC = 656.2725;
      CHECK(at_nm(focus, kC) - at_nm(focus, kF) == Approx(exact(kC) - exact(kF)).epsilon(2e-3));
    }
}
