// The measured Cornell box by the path tracer against an estimator with none of its refinements:
// single rays that bounce with a pdf in proportion to the cosine and count only when they meet the
// light by chance. It shares the shapes' intersections and the scene's curves, and nothing of
// core/integrators.
//
// Both estimate each pixel's colour with a known variance, so z = difference / standard deviation
// is nearly normal, its square summed over n pixels a chi-square of n, with mean n and variance 2
// n.

#include "core/planning/plan_extent.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace abbe;

namespace {

constexpr int kSide = 20, kBands = 9, kSurfaces = 5;
constexpr int kPaths = 10000; ///< of the brute-force estimator in each pixel
constexpr int kRenders = 64;  ///< of the path tracer, with seeds of their own

using Color = std::array<double, 3>;

struct Estimate {
  Color sum{}, squares{};
  int count = 0;

  void add(const Color& value) {
    ++count;
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += value[i];
      squares[i] += value[i] * value[i];
    }
  }
  [[nodiscard]] double mean(std::size_t i) const { return sum[i] / count; }
  /// Of the mean.
  [[nodiscard]] double variance(std::size_t i) const {
    return (squares[i] / count - mean(i) * mean(i)) / (count - 1);
  }
};

class BruteForce {
public:
  explicit BruteForce(const Scene& scene)
      : scene_(scene), world_(scene.shapes, farthest_coordinate(scene)) {
    const BandGrid grid(kBands);
    for (const Material& material : scene.materials) {
      std::array<double, kBands> reflectance{};
      for (int b = 0; b < kBands; ++b)
        reflectance[static_cast<std::size_t>(b)] = material.diffuse.at(grid.center_nm(b));
      reflectances_.push_back(reflectance);
      if (material.emission.constant_value() != 0.0) lamp_ = band_weights(grid, material.emission);
    }
  }

  Color sample(int x, int y) {
    const double scale = 2.0 * std::tan(scene_.camera.field_of_view_deg * kPi / 360.0) / kSide;
    // The camera of the box looks along +z, with y up and x to the left.
    const dvec3 direction{-scale * (x + uniform() - 0.5 * kSide),
                          -scale * (y + uniform() - 0.5 * kSide), 1.0};
    RayState state;
    state.ray = {scene_.camera.eye, glm::normalize(direction)};
    std::array<double, kBands> throughput;
    throughput.fill(1.0);
    Color color{};
    for (int surface = 0;; ++surface) {
      const auto hit = world_.closest(state);
      if (!hit) return color;
      const Material& material = scene_.materials[hit->material.index()];
      if (material.emission.constant_value() != 0.0 && hit->entering)
        for (std::size_t b = 0; b < kBands; ++b) {
          color[0] += throughput[b] * lamp_[b].x;
          color[1] += throughput[b] * lamp_[b].y;
          color[2] += throughput[b] * lamp_[b].z;
        }
      if (surface == kSurfaces) return color;
      for (std::size_t b = 0; b < kBands; ++b)
        throughput[b] *= reflectances_[hit->material.index()][b];
      state.ray = {hit->point, bounce(hit->entering ? hit->normal : -hit->normal)};
      hit->go_on(false, state.contacts, state.nesting);
    }
  }

private:
  static constexpr double kPi = std::numbers::pi;
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  /// The normal plus a point of the unit sphere has a pdf in proportion to the cosine.
  dvec3 bounce(const dvec3& normal) {
    const double z = 1.0 - 2.0 * uniform(), angle = 2.0 * kPi * uniform();
    const double r = std::sqrt(1.0 - z * z);
    return glm::normalize(normal + dvec3(r * std::cos(angle), r * std::sin(angle), z));
  }

  const Scene& scene_;
  World world_;
  std::vector<std::array<double, kBands>> reflectances_;
  std::vector<Xyz> lamp_;
  std::mt19937_64 random_{20261122};
};

Scene box() {
  Scene scene = test::project_scene("cornell", kSide);
  scene.settings.filter = PixelFilter::box;
  scene.settings.bands = kBands;
  scene.settings.max_depth = kSurfaces;
  scene.settings.samples_per_pixel = 16;
  return scene;
}

} // namespace

TEST_CASE("the path tracer agrees with brute force in the Cornell box, in every pixel") {
  Scene scene = box();
  std::vector<Estimate> tracer(kSide * kSide), brute(kSide * kSide);
  const auto pixel = [](int x, int y) { return static_cast<std::size_t>(y * kSide + x); };
  for (int seed = 0; seed < kRenders; ++seed) {
    scene.settings.seed = static_cast<std::uint64_t>(seed);
    const Rendering r = test::render_scene(scene, false);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const Xyz c = r.film.color(x, y);
        tracer[pixel(x, y)].add({c.x, c.y, c.z});
      }
  }
  BruteForce estimator(scene);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int i = 0; i < kPaths; ++i)
        brute[pixel(x, y)].add(estimator.sample(x, y));

  for (std::size_t channel = 0; channel < 3; ++channel) {
    double chi2 = 0.0, sum = 0.0, largest = 0.0;
    int n = 0;
    for (std::size_t i = 0; i < tracer.size(); ++i) {
      const double variance = tracer[i].variance(channel) + brute[i].variance(channel);
      if (variance == 0.0) {
        CHECK(tracer[i].mean(channel) == brute[i].mean(channel)); // past the box: black
        continue;
      }
      const double z = (tracer[i].mean(channel) - brute[i].mean(channel)) / std::sqrt(variance);
      chi2 += z * z;
      sum += z;
      largest = std::max(largest, std::abs(z));
      ++n;
    }
    INFO("channel " << channel << ", " << n << " pixels, chi2 " << chi2 << ", sum " << sum
                    << ", largest " << largest);
    CHECK(n > kSide * kSide * 8 / 10);
    CHECK(std::abs(chi2 - n) < 5.0 * std::sqrt(2.0 * n));
    CHECK(std::abs(sum) < 5.0 * std::sqrt(n));
    CHECK(largest < 5.5);
  }
}
