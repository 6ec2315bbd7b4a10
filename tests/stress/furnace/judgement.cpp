#include "tests/stress/furnace/judgement.h"

#include "tests/render_text.h"
#include "tests/stress/furnace/random_numbers.h"
#include "tests/stress/furnace/reference_walk.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace abbe::stress {
namespace {

/// A deviation of this many standard errors is looked at again with 16 times the samples and a new
/// seed, up to kStages times. A right scene passes all stages with a chance of 1e-10 per band; a
/// bias is four times as many standard errors in each stage.
constexpr double kSuspicious = 3.5;
constexpr int kStages = 3;

/// A mean over independent values, its standard error, and how many rays followed a camera ray.
struct Measured {
  std::vector<double> mean, error;
  double rays_behind_camera = 0.0;
};

/// Adds up independent values of all bands.
class Replicates {
public:
  void add(const std::vector<double>& bands) {
    sum_.resize(bands.size());
    squares_.resize(bands.size());
    for (std::size_t b = 0; b < bands.size(); ++b) {
      sum_[b] += bands[b] - 1.0; // near 1 nothing cancels
      squares_[b] += (bands[b] - 1.0) * (bands[b] - 1.0);
    }
    ++count_;
  }
  [[nodiscard]] Measured measured() const {
    Measured result;
    for (std::size_t b = 0; b < sum_.size(); ++b) {
      const double mean = sum_[b] / count_;
      const double variance = std::max(0.0, squares_[b] / count_ - mean * mean);
      result.mean.push_back(1.0 + mean);
      result.error.push_back(std::sqrt(variance / (count_ - 1)));
    }
    return result;
  }

private:
  std::vector<double> sum_, squares_;
  int count_ = 0;
};

/// Renders `seeds` images. Pixels are independent, but where light paths serve all of them.
Measured measure(Scene scene, int size, int samples, int seeds) {
  scene.settings.width = scene.settings.height = size;
  scene.settings.samples_per_pixel = samples;
  scene.settings.threads = 1;
  const bool shared =
      scene.settings.integrator == Integrator::path && scene.settings.caustics != Caustics::off;
  const std::uint64_t first_seed = scene.settings.seed;
  Replicates replicates;
  std::uint64_t behind = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    scene.settings.seed = first_seed + static_cast<std::uint64_t>(seed);
    const Rendering r = test::render_scene(scene, true);
    behind += r.rays.reflected + r.rays.refracted + r.rays.scattered;
    std::vector<double> whole(static_cast<std::size_t>(r.film.bands()));
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        std::vector<double> pixel;
        for (int b = 0; b < r.film.bands(); ++b)
          pixel.push_back(r.film.radiance(x, y, b));
        for (std::size_t b = 0; b < pixel.size(); ++b)
          whole[b] += pixel[b] / (size * size);
        if (!shared) replicates.add(pixel);
      }
    if (shared) replicates.add(whole);
  }
  Measured result = replicates.measured();
  result.rays_behind_camera =
      static_cast<double>(behind) / (static_cast<double>(seeds) * size * size * samples);
  return result;
}

/// Each surface costs a throughput in float some three roundings of 2^-24.
double rounding(const Measured& measured) {
  return 3.0 * 0x1p-24 * (2.0 + measured.rays_behind_camera);
}

/// Asks again, with more samples, while the answer is suspicious. `measure_stage(samples, seed)`
/// measures, `slack(measured)` is what may be missing beside noise.
template <class MeasureStage, class Slack>
std::optional<std::string> differs(const std::vector<double>& expected,
                                   MeasureStage&& measure_stage, Slack&& slack) {
  std::optional<std::string> finding;
  int scale = 1;
  for (int stage = 0; stage < kStages; ++stage, scale *= 4) {
    const Measured m = measure_stage(scale, static_cast<std::uint64_t>(stage) * 1000);
    finding.reset();
    for (std::size_t b = 0; b < m.mean.size(); ++b) {
      const double off = m.mean[b] - expected[b];
      if (std::abs(off) <= kSuspicious * m.error[b] + slack(m)) continue;
      finding =
          fmt::format("band {} is {} +- {}, expected {}", b, m.mean[b], m.error[b], expected[b]);
      break;
    }
    if (!finding) return {};
  }
  return finding;
}

std::optional<std::string> wrong_in_furnace(const Scene& scene) {
  const bool by_path = scene.settings.integrator == Integrator::path;
  const bool seeds = by_path && scene.settings.caustics != Caustics::off;
  bool rough = false;
  for (const Material& material : scene.materials)
    rough |= by_path && material.roughness > 0.0;
  const auto stage = [&](int scale, std::uint64_t seed) {
    Scene again = scene;
    again.settings.seed += seed;
    return seeds ? measure(again, 4 * scale, 1, 16) : measure(again, 8 * scale, 2, 1);
  };
  return differs(std::vector<double>(static_cast<std::size_t>(scene.settings.bands), 1.0), stage,
                 [&](const Measured& m) {
                   // docs/decisions/surfaces.md: furnaces are met to 0.5 % at each rough surface.
                   return rounding(m) + (rough ? 0.005 * m.rays_behind_camera : 0.0);
                 });
}

/// Bits of all that a film holds of the picture.
std::vector<std::uint64_t> bits(const Rendering& r) {
  std::vector<std::uint64_t> all;
  const auto add = [&](double value) { all.push_back(std::bit_cast<std::uint64_t>(value)); };
  for (int y = 0; y < r.film.window().height(); ++y)
    for (int x = 0; x < r.film.window().width(); ++x) {
      const Xyz color = r.film.color(x, y);
      for (const double value : {color.x, color.y, color.z, r.film.alpha(x, y)})
        add(value);
      for (int b = 0; b < r.film.bands(); ++b)
        add(r.film.radiance(x, y, b));
    }
  return all;
}

std::optional<std::string> wrong_bytes(Scene scene) {
  scene.settings.width = 33; // six tiles
  scene.settings.height = 20;
  scene.settings.samples_per_pixel = 1;
  scene.settings.threads = 1;
  const auto picture = [](const Scene& changed, const char* embree = nullptr) {
    const Plan plan = make_plan(changed, changed.settings);
    const World world(changed.shapes, farthest_coordinate(changed), embree);
    return bits(render(changed, plan, world, BandPlace{}));
  };
  const auto expected = picture(scene);
  for (const int threads : {2, 7}) {
    Scene changed = scene;
    changed.settings.threads = threads;
    if (picture(changed) != expected) return fmt::format("{} threads change bytes", threads);
  }
  Scene changed = scene;
  changed.settings.skip = Skips(false);
  if (picture(changed) != expected) return "skips change bytes";
  changed = scene;
  changed.settings.tracing = Tracing::single;
  if (picture(changed) != expected) return "single rays change bytes";
  // Packets of four and eight rays.
  for (const char* embree : {"isa=sse2", "isa=avx"})
    if (picture(scene, embree) != expected) return fmt::format("Embree's {} changes bytes", embree);
  return {};
}

/// The scene, seen along one ray: all samples of all pixels go along it, so what they show differs
/// by random decisions alone.
Scene along_one_ray(const RandomScene& scene, const std::string& settings,
                    const std::array<double, 3>& target) {
  RandomScene narrow = scene;
  narrow.look_at = target;
  narrow.field_of_view = 1e-9;
  return test::scene_from(scene_text(narrow, "filter box " + settings));
}

std::optional<std::string> wrong_energy(const RandomScene& scene, const std::string& settings) {
  RandomNumbers random(scene.seed);
  const BandGrid grid(scene.bands);
  for (int ray = 0; ray < 6; ++ray) {
    std::array<double, 3> target{};
    for (double& x : target)
      x = random.between(-1.2, 1.2);
    const Scene seen = along_one_ray(scene, settings, target);
    const Vector eye(scene.eye[0], scene.eye[1], scene.eye[2]);
    const Line line{eye, glm::normalize(Vector(target[0], target[1], target[2]) - eye)};
    std::vector<double> escaped;
    double dropped = 0.0;
    std::string account;
    for (int b = 0; b < scene.bands; ++b) {
      const LightShares shares = ReferenceWalk(scene, grid.center_nm(b)).follow(line);
      escaped.push_back(static_cast<double>(shares.escaped));
      dropped = std::max(dropped, static_cast<double>(shares.dropped));
      account += fmt::format("; absorbed in band {}: {}", b, static_cast<double>(shares.absorbed));
      if (std::abs(shares.escaped + shares.absorbed + shares.dropped - 1) > 1e-12L)
        return "the reference's own account does not add up";
    }
    const bool by_path = seen.settings.integrator == Integrator::path;
    const auto finding = differs(
        escaped,
        [&](int scale, std::uint64_t seed) {
          Scene again = seen;
          again.settings.seed += seed;
          return by_path ? measure(again, 8 * scale, 4, 1) : measure(again, 2 * scale, 4, 1);
        },
        [&](const Measured& m) { return rounding(m) + dropped; });
    if (finding)
      return fmt::format("the ray to {} {} {}: {}{}", target[0], target[1], target[2], *finding,
                         account);
  }
  return {};
}

} // namespace

std::vector<Question> questions(const RandomScene& scene, Asked asked) {
  std::vector<Question> all;
  if (asked == Asked::energy)
    return {{asked, "integrator whitted minThroughput 1e-9"},
            {asked, "integrator path caustics off"}};
  const bool bytes = asked == Asked::bytes;
  if (!scene.needs_path()) all.push_back({asked, "integrator whitted"});
  if (!bytes || scene.seed % 2 == 0 || all.empty())
    all.push_back({asked, "integrator path caustics off"});
  // Without lamps there are no light paths.
  if (scene.surroundings == Surroundings::glowing_walls)
    all.push_back({asked, "integrator path caustics on"});
  return all;
}

std::optional<std::string> wrong(const RandomScene& scene, const Question& question) {
  if (question.asked == Asked::energy) return wrong_energy(scene, question.settings);
  const Scene read = test::scene_from(scene_text(scene, question.settings));
  return question.asked == Asked::bytes ? wrong_bytes(read) : wrong_in_furnace(read);
}

} // namespace abbe::stress
