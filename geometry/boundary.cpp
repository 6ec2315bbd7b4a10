#include "geometry/boundary.h"

#include <algorithm>
#include <tuple>

namespace abbe {
namespace {

bool before(const Candidate& a, const Candidate& b) {
  return a.crossing.t != b.crossing.t ? a.crossing.t < b.crossing.t : a.shape < b.shape;
}

MaterialId material_of(const PlacedShape& placed, FaceId face) {
  if (const auto* tree = std::get_if<CsgTree>(&placed.shape)) {
    const MaterialId own = tree->leaves()[static_cast<std::size_t>(face.leaf)].material;
    if (own.valid()) return own;
  }
  return placed.material;
}

/// Which of two coinciding shapes shows: an opaque one before a glass, then the higher priority,
/// then the one defined last (so a decal may lie on a wall).
bool shows_before(const std::vector<PlacedShape>& shapes, ShapeId a, ShapeId b) {
  const auto rank = [&](ShapeId id) {
    const PlacedShape& p = shapes[id.index()];
    return std::tuple(!p.medium.valid(), p.priority, id);
  };
  return rank(a) > rank(b);
}

/// Point and outward normal of a crossing, in the world.
void place(const PlacedShape& placed, FaceId face, const dvec3& near_point, Hit& hit) {
  const Transform& to_world = placed.to_world;
  const dvec3 local = to_world.inverse_point(near_point);
  std::visit(
      [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, CsgTree>) {
          const dvec3 on_surface = snapped(shape, local, face);
          hit.point = to_world.point(on_surface);
          hit.normal = to_world.normal(outward_normal(shape, on_surface, face));
        } else {
          const dvec3 on_surface = snapped(shape, local, face.face);
          hit.point = to_world.point(on_surface);
          hit.normal = to_world.normal(outward_normal(shape, on_surface, face.face));
        }
      },
      placed.shape);
}

void enter_or_leave(Nesting& nesting, ShapeId shape, bool entering) {
  const auto* found = std::find(nesting.begin(), nesting.end(), shape);
  if (!entering && found != nesting.end())
    nesting.erase(static_cast<std::size_t>(found - nesting.begin()));
  if (entering && found == nesting.end() && !nesting.full()) nesting.push_back(shape);
}

} // namespace

bool NearestCandidates::offer(const Candidate& candidate) {
  if (candidate.crossing.t - candidate.crossing.t_error > reach_) return false;
  reach_ = std::min(reach_, latest(candidate.crossing));
  if (!kept_.full()) {
    kept_.push_back(candidate);
    return true;
  }
  auto* last = std::max_element(kept_.begin(), kept_.end(), before);
  if (before(candidate, *last)) *last = candidate;
  return true;
}

FixedVector<Candidate, 8> NearestCandidates::boundary() const {
  FixedVector<Candidate, 8> nearest;
  for (const Candidate& c : kept_) {
    if (c.crossing.t - c.crossing.t_error > reach_) continue;
    nearest.push_back(c);
    for (std::size_t i = nearest.size() - 1; i > 0 && before(nearest[i], nearest[i - 1]); --i)
      std::swap(nearest[i], nearest[i - 1]);
  }
  return nearest;
}

MediumId medium_of(const std::vector<PlacedShape>& shapes, const Nesting& nesting) {
  MediumId medium;
  int highest = 0;
  ShapeId owner;
  for (const ShapeId id : nesting) {
    const PlacedShape& placed = shapes[id.index()];
    if (!placed.medium.valid()) continue;
    const bool above =
        !owner.valid() || placed.priority > highest || (placed.priority == highest && id > owner);
    if (!above) continue;
    owner = id;
    highest = placed.priority;
    medium = placed.medium;
  }
  return medium;
}

Boundary resolve(const std::vector<PlacedShape>& shapes, const RayState& state,
                 const FixedVector<Candidate, 8>& crossings) {
  Boundary boundary;
  Hit& hit = boundary.hit;
  hit.nesting_after = state.nesting;
  const Candidate* shown = nullptr;
  for (const Candidate& c : crossings) {
    const PlacedShape& placed = shapes[c.shape.index()];
    const bool solid = is_solid(placed.shape);
    if (solid) enter_or_leave(hit.nesting_after, c.shape, c.crossing.entering);
    if (!hit.same_side.full()) {
      const bool now_inside = solid && !c.crossing.entering;
      hit.same_side.push_back(
          {c.shape, c.crossing.face, now_inside ? Side::inside : Side::outside});
      hit.other_side.push_back(
          {c.shape, c.crossing.face, solid && !now_inside ? Side::inside : Side::outside});
    }
    if (!shown || shows_before(shapes, c.shape, shown->shape)) shown = &c;
  }
  const PlacedShape& placed = shapes[shown->shape.index()];
  hit.t = shown->crossing.t;
  hit.shape = shown->shape;
  hit.face = shown->crossing.face;
  hit.material = material_of(placed, hit.face);
  hit.medium_before = medium_of(shapes, state.nesting);
  const bool opaque = !placed.medium.valid();
  hit.medium_after = opaque ? hit.medium_before : medium_of(shapes, hit.nesting_after);
  boundary.visible = opaque || hit.medium_before != hit.medium_after;
  place(placed, hit.face, state.ray.at(hit.t), hit);
  hit.entering = is_solid(placed.shape) ? shown->crossing.entering
                                        : glm::dot(hit.normal, state.ray.direction) < 0.0;
  return boundary;
}

} // namespace abbe
