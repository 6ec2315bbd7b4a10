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
#include <numeric>
#include <optional>

namespace abbe {
namespace {

/// The paths of a chunk; their photons are kept in the order of their numbers. Splats of a chunk
/// are held back until its end, so it must be small.
constexpr std::uint32_t kChunk = 256;

/// So many paths of a light in turn belong to either half of them, by whose difference the noise of
/// splats is known. Each such run of the sampler's sequence is stratified in itself.
constexpr std::uint32_t kHalvesAlternate = 64;

/// Light paths that fill the photon map of one pass; what more there are add splats only.
constexpr std::uint32_t kMostMapped = 1u << 15;

/// The first pass's radius is at most this part of the scene's size, unless the settings give it.
constexpr double kLargestPart = 1.0 / 64.0;

/// The part of the current pass whose splats are in the film: whole multiples of 2^-32, as the film
/// counts, so that what is added from run to run, and by part after part, is 1 in the end.
double part_in_film(const LightPassState& state) {
  const auto is = [](ChunkSplats which) { return [which](ChunkSplats c) { return c == which; }; };
  const auto before = std::ranges::find_if_not(state.chunks, is(ChunkSplats::elsewhere));
  const auto chunks = static_cast<double>(state.chunks.size());
  const auto in_films =
      static_cast<double>(std::distance(state.chunks.begin(), before) +
                          std::ranges::count_if(state.chunks, is(ChunkSplats::added)));
  return std::round(0x1p32 * in_films / chunks) * 0x1p-32;
}

/// Leaves the splats of all chunks but its own to the other parts. Each part whose camera samples
/// need the pass has a run of chunks, after those of the parts before it.
void leave_to_others(LightPassState& state, int samples_per_pixel) {
  const int first = part_of_sample(state.samples.first, state.part.count, samples_per_pixel);
  const int last = part_of_sample(state.samples.last - 1, state.part.count, samples_per_pixel);
  const auto border = [&](int number) {
    const int place = std::clamp(number - first, 0, last - first + 1);
    return state.chunks.size() * static_cast<std::size_t>(place) /
           static_cast<std::size_t>(last - first + 1);
  };
  const std::size_t begin = border(state.part.number), end = border(state.part.number + 1);
  for (std::size_t c = 0; c < state.chunks.size(); ++c)
    if (c < begin || c >= end) state.chunks[c] = ChunkSplats::elsewhere;
}

/// By how much the numbers of chunks differ that come after each other: by a part of all that is
/// near the golden ratio, and such that each chunk has its turn. So a run that ends early has
/// followed about the same part of each light's chunks, however many lights there are.
std::size_t step_of_turns(std::size_t chunks) {
  std::size_t step = std::max<std::size_t>(1, chunks * 618 / 1000);
  while (std::gcd(step, chunks) > 1)
    ++step;
  return step;
}

} // namespace

double light_passes_in_film(const LightPassState& state) {
  return state.passes == 0 ? 0.0 : state.passes - 1 + part_in_film(state);
}

LightPasses::LightPasses(const Scene& scene, const Plan& plan, const World& world,
                         const PlacedCamera* camera)
    : plan_(plan), world_(world), camera_(camera),
      emission_(plan.caustics ? Emission(scene, plan) : Emission()), map_(camera != nullptr),
      largest_radius_(kLargestPart * scene_size(scene)) {
  if (needed()) emission_.place(world);
}

LightPasses::Paths LightPasses::paths_of(SampleRange samples) const {
  const double wanted = plan_.settings.light_paths * (samples.last - samples.first) *
                        plan_.settings.width * plan_.settings.height; // a crop sees them too
  const auto count = static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 0x1p30));
  Paths paths{emission_.shares(count), emission_.shares(std::min(count, kMostMapped)), {}};
  for (std::size_t e = 0; e < paths.shares.size(); ++e)
    for (std::uint32_t i = 0; i < paths.shares[e]; i += kChunk)
      paths.chunks.push_back({e, i, std::min(i + kChunk, paths.shares[e])});
  return paths;
}

void LightPasses::begin(LightPassState& state, SampleRange samples) const {
  state.begun.resize(emission_.lights().size(), 0);
  if (state.passes > 0) {
    const Paths ended = paths_of(state.samples);
    for (std::size_t e = 0; e < state.begun.size(); ++e)
      state.begun[e] += ended.shares[e];
  } else {
    state.first_radius = plan_.settings.photon_radius;
    state.first_samples = samples;
  }
  ++state.passes;
  state.samples = samples;
  state.chunks.assign(paths_of(samples).chunks.size(), ChunkSplats::missing);
  if (!state.part.is_whole()) leave_to_others(state, plan_.settings.samples_per_pixel);
}

bool LightPasses::find_first_radius(LightPassState& state, const IsOver& is_over) const {
  LightPassState first;
  begin(first, state.first_samples);
  std::ranges::fill(first.chunks, ChunkSplats::elsewhere);
  Film nowhere({}, {});
  const Followed followed =
      follow_chunks(paths_of(first.samples), Which::that_fill_the_map, first, {nowhere, is_over});
  if (followed.all) state.first_radius = first_photon_radius(followed.batches, largest_radius_);
  return followed.all;
}

bool LightPasses::follow(LightPaths& walker, const Chunk& chunk, const Paths& paths,
                         std::uint32_t begun, const Found& found) const {
  const std::size_t light = chunk.light;
  for (std::uint32_t i = chunk.first; i < chunk.last; ++i) {
    const Sampler sampler(~static_cast<int>(light), 0, begun + i, plan_.settings.seed);
    const auto ray = emission_.lights()[light].sample(sampler);
    if (!ray) continue;
    const bool keeps = i < paths.mapped[light];
    walker.set_half((begun + i) / kHalvesAlternate % 2 == 0);
    if (!walker.trace(*ray, sampler, 1.0 / paths.shares[light], keeps ? &found.photons : nullptr,
                      1.0 / std::min(paths.mapped[light], paths.shares[light]), found.counts))
      return false;
  }
  return true;
}

LightPasses::Followed LightPasses::follow_chunks(const Paths& paths, Which which,
                                                 LightPassState& state, const Run& run) const {
  const std::size_t count = paths.chunks.size(), step = step_of_turns(count);
  Film nowhere({}, {}); // it has no pixels, so that splats fall beside it
  const bool maps = which == Which::that_fill_the_map;
  Followed result{std::vector<PhotonBatch>(count), {}, false};
  std::vector<RayCounts> counts(count);
  std::atomic<std::size_t> followed = 0;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const auto& range) {
    const DenormalsOff denormals_off;
    std::optional<LightPaths> with_splats, without; // made once they are needed
    for (std::size_t turn = range.begin(); turn < range.end() && !run.is_over(); ++turn) {
      const std::size_t c = turn * step % count;
      const bool known = state.chunks[c] != ChunkSplats::missing || !run.share.has(c);
      Chunk chunk = paths.chunks[c];
      if (known) chunk.last = std::min(chunk.last, paths.mapped[chunk.light]);
      if ((chunk.first < paths.mapped[chunk.light]) != maps || chunk.first >= chunk.last) {
        ++followed;
        continue;
      }
      counts[c].record = run.record;
      std::optional<LightPaths>& walker = known ? without : with_splats;
      if (!walker) walker.emplace(plan_, world_, emission_, camera_, known ? nowhere : run.film);
      walker->end_with(run.is_over);
      const Found found{result.batches[c], counts[c]};
      if (!follow(*walker, chunk, paths, state.begun[chunk.light], found)) {
        walker->drop_splats();
        counts[c] = {};
        break;
      }
      walker->add_splats();
      if (known)
        counts[c] = {};
      else
        state.chunks[c] = ChunkSplats::added;
      ++followed;
    }
  });
  for (const RayCounts& c : counts)
    result.rays += c;
  result.all = followed == count;
  return result;
}

LightPasses::Followed LightPasses::follow_and_count(const Paths& paths, Which which,
                                                    LightPassState& state, const Run& run) const {
  const double before = part_in_film(state);
  Followed followed = follow_chunks(paths, which, state, run);
  if (run.share.count == 1) run.film.add_light_passes(part_in_film(state) - before);
  return followed;
}

RayCounts LightPasses::fill_map(LightPassState& state, const Run& run) {
  if (has_map(state)) return {};
  const auto begin = std::chrono::steady_clock::now();
  if (state.passes > 1 && !(state.first_radius > 0.0) && !find_first_radius(state, run.is_over))
    return {};
  Followed followed =
      follow_and_count(paths_of(state.samples), Which::that_fill_the_map, state, run);
  if (followed.all) {
    if (!(state.first_radius > 0.0))
      state.first_radius = first_photon_radius(followed.batches, largest_radius_);
    map_.build(followed.batches, photon_radius(state.first_radius, state.passes - 1));
    mapped_pass_ = state.passes;
  }
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return followed.rays;
}

RayCounts LightPasses::add_splats(LightPassState& state, const Run& run) {
  if (std::ranges::find(state.chunks, ChunkSplats::missing) == state.chunks.end()) return {};
  const auto begin = std::chrono::steady_clock::now();
  const Followed followed =
      follow_and_count(paths_of(state.samples), Which::that_only_splat, state, run);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return followed.rays;
}

} // namespace abbe
