// Rays through the zoo of shapes: at random, and aimed at what is hard. Each walks on from what it
// meets, straight or turned back, and every answer is compared with exact bodies.
#include "tests/stress/part.h"
#include "tests/stress/ray_aims.h"
#include "tests/stress/ray_judge.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace abbe::stress {
namespace {

constexpr int kWalks = 1500;
constexpr int kSteps = 16;

/// Straight on, turned back, or bent, but to the side of the surface that the contact tells.
RayState bounced(const World& world, const RayState& state, const Hit& hit, Random& random) {
  const PlacedShape& shape = world.shapes()[hit.shape.index()];
  const bool opaque = !shape.medium.valid() && is_solid(shape.shape);
  const bool back = opaque || random.chance(0.5);
  dvec3 d = state.ray.direction;
  if (back) d -= 2.0 * glm::dot(d, hit.normal) * hit.normal;
  if (random.chance(0.5)) {
    const dvec3 bent = glm::normalize(d + random.in_cube(random.chance(0.5) ? 1e-3 : 1.0));
    if ((glm::dot(bent, hit.normal) > 0.0) == (hit.entering == back)) d = bent;
  }
  return hit.going_on(glm::normalize(d), !back);
}

void walk(const World& world, RayState state, RayJudge& judge, Random& random) {
  const bool straight = random.chance(0.4);
  Passage passage;
  Hit hit;
  for (int step = 0; step < kSteps; ++step) {
    const bool at_one_place = straight && !passage.crossed().empty();
    if (straight)
      world.find_closest(state, kInfinity, passage, hit);
    else
      world.find_closest(state, hit);
    judge.check(state, hit, at_one_place);
    if (!straight && random.chance(0.2))
      judge.check_occluded(state, hit,
                           hit.met() ? hit.t * random.uniform(0.5, 1.5) : random.uniform(0.0, 9.0));
    if (!hit.met() || judge.spoilt()) return;
    if (!straight)
      state = bounced(world, state, hit, random);
    else if (!passage.go_through(hit, state))
      return;
  }
}

/// Rays in packets have the bits of single rays.
void check_packets(const World& world, std::span<const RayState> states, Tally& tally,
                   std::uint64_t round) {
  std::vector<Hit> hits(states.size());
  world.find_closest(states, hits, Tracing::packets);
  for (std::size_t i = 0; i < states.size(); ++i) {
    Hit single;
    world.find_closest(states[i], single);
    tally.count("rays_in_packets");
    if (single.met() != hits[i].met() ||
        (single.met() && (single.t != hits[i].t || single.shape != hits[i].shape ||
                          !(single.face == hits[i].face)))) {
      tally.fail("packet", fmt::format("round {} ray {}: o ({:a},{:a},{:a}) t {:a} shape {} in a "
                                       "packet, t {:a} shape {} alone",
                                       round, i, states[i].ray.origin.x, states[i].ray.origin.y,
                                       states[i].ray.origin.z, hits[i].t, hits[i].shape.value,
                                       single.t, single.shape.value));
    }
  }
}

void round(std::uint64_t number, Tally& tally) {
  Random random(0x5eed + number);
  const RayScene scene = ray_scene(static_cast<int>(number % kKindsOfScenes), random);
  constexpr double kReach = 8.0; // in sizes, of rays that start nearby
  const double far = random.chance(0.2) ? std::pow(10.0, random.uniform(1.0, 6.0)) : kReach;
  const World world(scene.shapes, glm::length(scene.middle) + far * scene.size);
  RayJudge judge(scene, world, number, tally);
  RayAims aims(scene, world, judge, far, random);
  std::vector<RayState> starts;
  for (int i = 0; i < kWalks; ++i) {
    const auto start = aims.next();
    if (!start) continue;
    judge.begin(start->kind);
    if (start->state.contacts.empty()) {
      judge.check_nesting(start->state.ray.origin, start->state.nesting);
      if (starts.size() < 64) starts.push_back(start->state);
    }
    walk(world, start->state, judge, random);
  }
  check_packets(world, starts, tally, number);
}

} // namespace

const Part kPart{"rays", 140, 260000, Rounds::on_all_cores, round};

} // namespace abbe::stress
