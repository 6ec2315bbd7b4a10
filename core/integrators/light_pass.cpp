#include "core/integrators/light_pass.h"

#include "core/bundles/denormals.h"
#include "core/integrators/light_paths.h"
#include "core/integrators/photon_radius.h"
#include "core/lights/scene_extent.h"
#include "core/sampling/sampler.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace abbe {
namespace {

/// Paths that one task follows; their photons are kept in the order of their numbers.
constexpr std::uint32_t kChunk = 2048;

/// Light paths that fill the photon map of one pass; what more there are add splats only.
constexpr std::uint32_t kMostMapped = 1u << 15;

/// A run of one emitter's paths.
struct Chunk {
  std::size_t emitter;
  std::uint32_t first, last; ///< numbers among the emitter's paths of this pass
};

/// The first pass's radius is at most this part of the scene's size, unless the settings give it.
constexpr double kLargestPart = 1.0 / 64.0;

} // namespace

LightPasses::LightPasses(const Scene& scene, const Plan& plan, const World& world,
                         const PlacedCamera* camera, Film& film)
    : plan_(plan), world_(world), camera_(camera), film_(film),
      emission_(plan.caustics ? Emission(scene, plan) : Emission()), map_(camera != nullptr),
      largest_radius_(kLargestPart * scene_size(scene)), first_radius_(plan.settings.photon_radius),
      begun_(emission_.lights().size(), 0) {
  if (!needed()) return;
  emission_.place(world);
  if (camera_) film.enable_splats();
}

RayCounts LightPasses::run(int pass, int samples, const std::atomic<bool>& stop,
                           RayRecord* record) {
  const auto begin = std::chrono::steady_clock::now();
  const double wanted =
      plan_.settings.light_paths * samples * static_cast<double>(plan_.window.pixel_count());
  const auto paths = static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 0x1p30));
  const std::vector<std::uint32_t> shares = emission_.shares(paths);
  const std::vector<std::uint32_t> mapped = emission_.shares(std::min(paths, kMostMapped));
  std::vector<Chunk> chunks;
  for (std::size_t e = 0; e < shares.size(); ++e)
    for (std::uint32_t i = 0; i < shares[e]; i += kChunk)
      chunks.push_back({e, i, std::min(i + kChunk, shares[e])});

  std::vector<PhotonBatch> batches(chunks.size());
  std::vector<RayCounts> counts(chunks.size());
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks.size(), 1), [&](const auto& range) {
    const DenormalsOff denormals_off;
    LightPaths walker(plan_, world_, emission_, camera_, film_);
    for (std::size_t c = range.begin(); c < range.end() && !stop; ++c) {
      const Chunk& chunk = chunks[c];
      const std::size_t e = chunk.emitter;
      counts[c].record = record;
      for (std::uint32_t i = chunk.first; i < chunk.last; ++i) {
        const Sampler sampler(~static_cast<int>(e), 0, begun_[e] + i, plan_.settings.seed);
        const auto ray = emission_.lights()[e].sample(sampler);
        if (!ray) continue;
        const bool keeps = i < mapped[e];
        walker.trace(*ray, sampler, 1.0 / shares[e], keeps ? &batches[c] : nullptr,
                     1.0 / std::min(mapped[e], shares[e]), counts[c]);
      }
      ++done;
    }
  });
  film_.add_light_passes(static_cast<double>(done) / static_cast<double>(chunks.size()));
  for (std::size_t e = 0; e < shares.size(); ++e)
    begun_[e] += shares[e];
  if (!(first_radius_ > 0.0)) first_radius_ = first_photon_radius(batches, largest_radius_);
  map_.build(batches, photon_radius(first_radius_, pass));
  RayCounts total;
  for (const RayCounts& c : counts)
    total += c;
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return total;
}

} // namespace abbe
