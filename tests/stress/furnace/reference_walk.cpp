#include "tests/stress/furnace/reference_walk.h"

#include "spectral/glass.h"
#include "tests/stress/furnace/reference_optics.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace abbe::stress {
namespace {

/// Crossings closer than this are one place. Faces that are meant to coincide do so to 1e-15.
constexpr Real kOnePlace = 1e-10L;
constexpr Real kFaint = 1e-7L;
constexpr int kMostRays = 20000;
constexpr int kVacuum = -1;

bool opaque(const Substance& substance) {
  return !substance.lets_light_in() || substance.transparency == 0.0;
}

/// What a surface does with light, by its substance.
Split split(const Substance& s, Real sine, Real n_before, Real n_after, Real lambda_nm) {
  if (s.kind == Substance::Kind::pane)
    return pane_split(sine, n_before, {s.layer.index, s.layer.thickness, s.absorption});
  if (s.kind == Substance::Kind::mirror) return {s.reflectivity, 0};
  const bool total = n_before * sine >= n_after;
  if (s.kind == Substance::Kind::shares)
    return {s.reflectivity, total || opaque(s) ? 0 : Real(s.transparency)};
  const Split whole =
      s.layer.thickness > 0.0
          ? filmed_split(sine, n_before, {s.layer.index, s.layer.thickness, lambda_nm}, n_after)
          : boundary_split(sine, n_before, n_after);
  return {whole.reflected * Real(s.reflectivity), whole.passed * Real(s.transparency)};
}

} // namespace

struct ReferenceWalk::Event {
  Real t;
  int item;
  Vector normal;
};

/// What a ray meets: whose surface, and what fills the places before and behind.
struct ReferenceWalk::Boundary {
  Event seen{};
  int before = kVacuum, after = kVacuum;
};

struct ReferenceWalk::Branch {
  Line ray;
  Real weight;
};

ReferenceWalk::ReferenceWalk(const RandomScene& scene, double lambda_nm)
    : scene_(scene), lambda_nm_(lambda_nm) {
  for (const Item& item : scene.items) {
    const Glass* glass = find_glass(item.substance.glass);
    indices_.push_back(glass ? refractive_index(glass->dispersion, lambda_nm)
                             : item.substance.index);
  }
}

int ReferenceWalk::filling(const std::vector<bool>& holds) const {
  int best = kVacuum;
  for (int i = 0; i < static_cast<int>(scene_.items.size()); ++i) {
    const Item& item = scene_.items[static_cast<std::size_t>(i)];
    if (!holds[static_cast<std::size_t>(i)] || item.solid.flat() || opaque(item.substance))
      continue;
    if (best == kVacuum || item.priority >= scene_.items[static_cast<std::size_t>(best)].priority)
      best = i;
  }
  return best;
}

bool ReferenceWalk::same_medium(int a, int b) const {
  if (a == b) return true;
  if (a == kVacuum || b == kVacuum) return false;
  const Substance &x = scene_.items[static_cast<std::size_t>(a)].substance,
                  &y = scene_.items[static_cast<std::size_t>(b)].substance;
  return x.glass == y.glass && (!x.glass.empty() || x.index == y.index) &&
         x.absorption == y.absorption && x.dispersion_scale == y.dispersion_scale;
}

Real ReferenceWalk::index_of(int item) const {
  return item == kVacuum ? 1 : indices_[static_cast<std::size_t>(item)];
}

bool ReferenceWalk::next_boundary(const Line& ray, Boundary& found) const {
  std::vector<Event> events;
  for (int i = 0; i < static_cast<int>(scene_.items.size()); ++i)
    for (const SurfaceCrossing& c : crossings(scene_.items[static_cast<std::size_t>(i)].solid, ray))
      events.push_back({c.t, i, c.normal});
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });

  std::vector<bool> holds(scene_.items.size(), false);
  for (std::size_t i = 0; i < events.size();) {
    const Real t = events[i].t;
    const int before = filling(holds);
    const Event* seen = nullptr;
    for (; i < events.size() && events[i].t - t < kOnePlace; ++i) {
      const Event& event = events[i];
      const auto number = static_cast<std::size_t>(event.item);
      holds[number] = !holds[number];
      const auto rank = [&](const Event& e) {
        const Item& item = scene_.items[static_cast<std::size_t>(e.item)];
        return std::tuple(item.solid.flat() || opaque(item.substance), item.priority, e.item);
      };
      if (!seen || rank(event) > rank(*seen)) seen = &event;
    }
    if (t < kOnePlace) continue;
    const int after = filling(holds);
    const Item& item = scene_.items[static_cast<std::size_t>(seen->item)];
    if (!item.solid.flat() && !opaque(item.substance) && same_medium(before, after)) continue;
    found = {*seen, before, after};
    return true;
  }
  return false;
}

LightShares ReferenceWalk::follow(const Line& ray) const {
  LightShares shares;
  std::vector<Branch> branches{{ray, 1}};
  for (int rays = 0; !branches.empty(); ++rays) {
    Branch branch = branches.back();
    branches.pop_back();
    if (branch.weight < kFaint || rays >= kMostRays) {
      shares.dropped += branch.weight;
      continue;
    }
    Boundary met;
    if (!next_boundary(branch.ray, met)) {
      shares.escaped += branch.weight;
      continue;
    }
    if (met.before != kVacuum) {
      const Real absorption =
          scene_.items[static_cast<std::size_t>(met.before)].substance.absorption;
      const Real kept = std::exp(-absorption * met.seen.t);
      shares.absorbed += branch.weight * (1 - kept);
      branch.weight *= kept;
    }
    const Vector& d = branch.ray.direction;
    const Vector normal = glm::dot(met.seen.normal, d) > 0 ? -met.seen.normal : met.seen.normal;
    const Real cosine = std::min<Real>(1, -glm::dot(normal, d));
    const Vector along = d + cosine * normal;
    const Real sine = glm::length(along);
    const Substance& s = scene_.items[static_cast<std::size_t>(met.seen.item)].substance;
    const bool pane = s.kind == Substance::Kind::pane;
    const Real n_before = index_of(met.before), n_after = pane ? n_before : index_of(met.after);
    const Split parts = split(s, sine, n_before, n_after, lambda_nm_);
    shares.absorbed += branch.weight * (1 - parts.reflected - parts.passed);
    const Vector point = branch.ray.at(met.seen.t);
    if (parts.reflected > 0)
      branches.push_back(
          {{point, glm::normalize(d + 2 * cosine * normal)}, branch.weight * parts.reflected});
    if (parts.passed > 0) {
      const Vector bent = along * (n_before / n_after);
      const Vector onwards =
          pane ? d : bent - normal * std::sqrt(std::max<Real>(0, 1 - glm::dot(bent, bent)));
      branches.push_back({{point, glm::normalize(onwards)}, branch.weight * parts.passed});
    }
  }
  return shares;
}

} // namespace abbe::stress
