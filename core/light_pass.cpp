#include "core/light_pass.h"

#include "core/denormals.h"
#include "core/integrators/light_paths.h"
#include "core/plan_extent.h"
#include "core/sampler.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Paths that one task follows; their photons are kept in the order of their numbers.
constexpr std::uint32_t kChunk = 2048;

/// Light paths that fill the photon map of one pass; what more there are add splats only.
constexpr std::uint32_t kMostMapped = 1u << 15;

/// For the first radius: photons that each band shall have within it, photons that are compared,
/// and those of them whose neighbours are counted.
constexpr double kPhotonsPerBand = 24.0;
constexpr std::size_t kMostCompared = 1u << 14, kAsked = 128;

/// A run of one emitter's paths.
struct Chunk {
  std::size_t emitter;
  std::uint32_t first, last; ///< numbers among the emitter's paths of this pass
};

/// The first pass's radius is at most this part of the scene's size, unless the settings give it.
constexpr double kLargestPart = 1.0 / 64.0;

} // namespace

double radius_for(std::span<const PhotonBatch> batches, int bands_in_all, double largest) {
  std::vector<dvec3> places;
  double bands = 0.0;
  std::size_t count = 0;
  for (const PhotonBatch& batch : batches)
    count += batch.photons.size();
  if (count == 0) return largest;
  // Every so many of them stands for those beside it.
  const std::size_t step = (count + kMostCompared - 1) / kMostCompared;
  std::size_t i = 0;
  for (const PhotonBatch& batch : batches)
    for (const Photon& photon : batch.photons) {
      bands += photon.last - photon.first;
      if (i++ % step == 0) places.push_back(photon.position);
    }
  // So many photons give each band kPhotonsPerBand: a narrow bundle counts for its bands alone.
  const double mean_bands = bands / static_cast<double>(count);
  const double wanted = kPhotonsPerBand * bands_in_all / std::max(mean_bands, 1.0);
  const auto rank = static_cast<std::size_t>(
      std::clamp(wanted / static_cast<double>(step), 1.0, static_cast<double>(places.size())));
  std::vector<double> radii, distances(places.size());
  const std::size_t stride = std::max<std::size_t>(1, places.size() / kAsked);
  for (std::size_t p = 0; p < places.size(); p += stride) {
    for (std::size_t q = 0; q < places.size(); ++q)
      distances[q] = glm::distance(places[p], places[q]);
    const auto nth = distances.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(distances.begin(), nth, distances.end());
    radii.push_back(*nth);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle > 0.0 ? std::min(*middle, largest) : largest;
}

double photon_radius(double first_radius, int pass) {
  constexpr double kAlpha = 2.0 / 3.0;
  double square = first_radius * first_radius;
  for (int i = 1; i <= pass; ++i)
    square *= (i + kAlpha) / (i + 1.0);
  return std::sqrt(square);
}

LightPasses::LightPasses(const Scene& scene, const Plan& plan, const World& world,
                         const CameraRays* camera, Film& film)
    : plan_(plan), world_(world), camera_(camera), film_(film),
      emission_(plan.caustics ? Emission(scene, plan) : Emission()), map_(camera != nullptr),
      largest_radius_(kLargestPart * scene_size(scene)), first_radius_(plan.settings.photon_radius),
      begun_(emission_.emitters().size(), 0) {
  if (!needed()) return;
  emission_.place(world);
  if (camera_) film.enable_splats();
}

RayCounts LightPasses::run(int pass, int samples, const std::atomic<bool>& stop,
                           RayRecord* record) {
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
        const auto ray = emission_.emitters()[e].sample(sampler);
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
  if (!(first_radius_ > 0.0))
    first_radius_ = radius_for(batches, plan_.grid.count(), largest_radius_);
  map_.build(batches, photon_radius(first_radius_, pass));
  RayCounts total;
  for (const RayCounts& c : counts)
    total += c;
  return total;
}

} // namespace abbe
