#include "bench/measurements/replay.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace abbe::bench {
namespace {

constexpr std::size_t kChunk = 1024; ///< rays that a thread takes at a time
constexpr std::size_t kWidest = 16;  ///< what the world traces together

/// Calls work(begin, end) for chunks of [0, count) on several threads; sums what it returns.
template <class Work>
std::size_t in_chunks(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next = 0, total = 0;
  const auto run = [&] {
    std::size_t sum = 0;
    for (std::size_t begin = next.fetch_add(kChunk); begin < count; begin = next.fetch_add(kChunk))
      sum += work(begin, std::min(begin + kChunk, count));
    total += sum;
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads; ++i)
    helpers.emplace_back(run);
  run();
  helpers.clear(); // joins
  return total;
}

} // namespace

const char* name(RayKind kind) {
  switch (kind) {
  case RayKind::camera:
    return "camera";
  case RayKind::reflected:
    return "reflected";
  case RayKind::refracted:
    return "refracted";
  case RayKind::scattered:
    return "scattered";
  case RayKind::shadow:
    return "shadow";
  case RayKind::light:
    return "light";
  }
  return "";
}

std::vector<RaysOfKind> by_kind(const RayRecord& record) {
  std::vector<RaysOfKind> result;
  for (const RayKind kind : kRayKinds) {
    RaysOfKind rays;
    rays.kind = kind;
    std::size_t at = 0;
    for (const RayRecord::Run& run : record.runs) {
      if (run.kind == kind) {
        rays.any_hit = run.any_hit;
        const auto first = static_cast<std::ptrdiff_t>(at);
        const auto last = static_cast<std::ptrdiff_t>(at + run.count);
        rays.states.insert(rays.states.end(), record.states.begin() + first,
                           record.states.begin() + last);
        rays.distances.insert(rays.distances.end(), record.distances.begin() + first,
                              record.distances.begin() + last);
      }
      at += run.count;
    }
    if (!rays.states.empty()) result.push_back(std::move(rays));
  }
  return result;
}

std::size_t replay(const World& world, const RaysOfKind& rays, int width, int threads) {
  const std::span<const RayState> states = rays.states;
  const std::span<const double> distances = rays.distances;
  return in_chunks(states.size(), threads, [&](std::size_t begin, std::size_t end) {
    return rays.any_hit ? world.replay_occluded(states.subspan(begin, end - begin),
                                                distances.subspan(begin, end - begin))
                        : world.replay_closest(states.subspan(begin, end - begin), width);
  });
}

std::size_t query(const World& world, const RaysOfKind& rays, int threads) {
  const bool packets = rays.kind == RayKind::camera || rays.kind == RayKind::refracted;
  const Tracing tracing = packets ? Tracing::packets : Tracing::single;
  const std::span<const RayState> states = rays.states;
  return in_chunks(states.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::array<Hit, kWidest> hits;
    std::size_t met = 0;
    const std::size_t step = packets ? kWidest : 1;
    for (std::size_t at = begin; at < end; at += step) {
      const std::size_t count = std::min(step, end - at);
      if (rays.any_hit) {
        for (std::size_t i = at; i < at + count; ++i)
          met += world.occluded(states[i], rays.distances[i]) ? 1 : 0;
        continue;
      }
      const auto found = std::span(hits).first(count);
      world.find_closest(states.subspan(at, count), found, tracing);
      for (const Hit& hit : found)
        met += hit.met() ? 1 : 0;
    }
    return met;
  });
}

} // namespace abbe::bench
