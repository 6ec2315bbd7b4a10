#include "geometry/world/boundary.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace abbe {
namespace {

bool before(const Candidate& a, const Candidate& b) {
  return a.crossing.t != b.crossing.t ? a.crossing.t < b.crossing.t : a.shape < b.shape;
}

MaterialId material_of(const ShapeTable::Row& row, FaceId face) {
  if (row.tree) {
    const auto& tree = *std::get_if<CsgTree>(&row.placed->shape);
    const MaterialId own = tree.leaves()[static_cast<std::size_t>(face.leaf)].material;
    if (own.valid()) return own;
  }
  return row.material;
}

/// Point and outward normal of a crossing, in the world.
void place(const ShapeTable& shapes, const ShapeTable::Row& row, const dvec3& near_point,
           Hit& hit) {
  const dvec3 local = row.from_world.inverse_point(near_point);
  std::visit(
      [&](const auto& shape) {
        const dvec3 on_surface = snapped(shape, local, hit.face);
        hit.point = row.to_world.point(on_surface);
        hit.normal = row.first_normal >= 0
                         ? shapes.normal(row, hit.face)
                         : row.to_world.normal(outward_normal(shape, on_surface, hit.face));
      },
      row.placed->shape);
}

/// Where a ray would run through the surface in one sense by the shading normal and in the other by
/// the true one, as close to a silhouette, the surface is as flat as it is.
[[gnu::noinline]] dvec3 smooth_normal(const ShapeTable::Row& row, const dvec3& direction,
                                      const Hit& hit) {
  const auto& mesh = *std::get_if<Mesh>(&row.placed->shape);
  const auto local = shading_normal(mesh, row.from_world.inverse_point(hit.point), hit.face.face);
  if (!local) return hit.normal;
  const dvec3 normal = row.to_world.normal(*local);
  const bool same =
      (glm::dot(normal, direction) < 0.0) == hit.entering && glm::dot(normal, direction) != 0.0;
  return same ? normal : hit.normal;
}

/// The crossing that shows, never the one that rounding happens to put first.
[[gnu::noinline]] const Candidate& shown(const ShapeTable& shapes, const Coincident& crossings) {
  const Candidate* highest = crossings.begin();
  for (const Candidate& c : crossings)
    if (&c != highest && shows_before(shapes, c.shape, highest->shape)) highest = &c;
  return *highest;
}

/// The other crossings of the boundary.
[[gnu::noinline]] void add_beside(const ShapeTable& shapes, const Coincident& crossings, Hit& hit) {
  for (const Candidate& c : crossings)
    if (c.shape != hit.shape)
      hit.beside.push_back({c.shape, c.crossing.face,
                            c.crossing.entering ? Side::outside : Side::inside, true,
                            shapes[c.shape].solid});
}

/// Where the ray has not moved, it still lies on the surfaces it lay on: a ray in a corner meets
/// one wall after another.
[[gnu::noinline]] void keep_contacts(const Contacts& contacts, Hit& hit) {
  for (const SurfaceContact& old : contacts) {
    const bool crossed = old.shape == hit.shape || std::any_of(hit.beside.begin(), hit.beside.end(),
                                                               [&](const SurfaceBeside& beside) {
                                                                 return beside.shape == old.shape;
                                                               });
    if (!crossed) hit.beside.push_back({old.shape, old.face, old.side, false, false});
  }
}

/// True where rounding cannot tell the place of a crossing from the ray's origin. A root's error is
/// that of the surface's place, seen along the ray.
bool has_not_moved(const RayState& state, double t_error, const Hit& hit) {
  return hit.t <= t_error && hit.t <= t_error * std::abs(glm::dot(hit.normal, state.ray.direction));
}

/// Where the boundary is that crossings make together: the place of the one that shows, or the
/// nearest to it at which rounding may have put each of them. A ray along a plane may cross it
/// anywhere, and coincides with what it meets on the way; the boundary is there, not where the
/// root of the plane happens to be.
[[gnu::noinline]] double common_place(const Coincident& crossings, double t) {
  double first = 0.0, last = kInfinity;
  for (const Candidate& c : crossings) {
    first = std::max(first, c.crossing.t - c.crossing.t_error);
    last = std::min(last, c.crossing.t + c.crossing.t_error);
  }
  return std::clamp(t, first, last);
}

} // namespace

void NearestCandidates::offer_beside_others(const Candidate& candidate) {
  for (std::size_t i = kept_.size(); i-- > 0;)
    if (kept_[i].crossing.t - kept_[i].crossing.t_error > reach_) kept_.erase(i);
  std::size_t place = kept_.size();
  while (place > 0 && before(candidate, kept_[place - 1]))
    --place;
  kept_.insert(place, candidate);
}

bool shows_before(const ShapeTable& shapes, ShapeId a, ShapeId b) {
  const auto rank = [&](ShapeId id) {
    const ShapeTable::Row& row = shapes[id];
    return std::tuple(!row.gives_way, !row.medium.valid(), row.priority, id);
  };
  return rank(a) > rank(b);
}

MediumId prevailing_medium(const ShapeTable& shapes, const Nesting& nesting) {
  const ShapeTable::Row* prevailing = nullptr;
  ShapeId owner;
  for (const ShapeId id : nesting) {
    const ShapeTable::Row& row = shapes[id];
    if (!row.medium.valid()) continue;
    if (prevailing && std::tuple(row.priority, id) < std::tuple(prevailing->priority, owner))
      continue;
    prevailing = &row;
    owner = id;
  }
  return prevailing ? prevailing->medium : MediumId{};
}

namespace {

/// The medium behind a boundary. Most rays enter a solid from the open, or leave the only one.
MediumId medium_behind(const ShapeTable& shapes, const ShapeTable::Row& shown, const Hit& hit) {
  if (hit.beside.empty()) [[likely]] {
    if (!hit.solid) return hit.medium_before;
    const Nesting& before = hit.nesting_before;
    if (hit.entering && before.empty()) return shown.medium;
    if (!hit.entering && before.size() == 1 && before[0] == hit.shape) return {};
  }
  return medium_of(shapes, hit.nesting_after());
}

} // namespace

bool resolve(const ShapeTable& shapes, const RayState& state, const Coincident& crossings,
             Hit& hit) {
  const bool single = crossings.size() == 1;
  const Candidate& seen = single ? crossings[0] : shown(shapes, crossings);
  const ShapeTable::Row& row = shapes[seen.shape];
  hit.t = single ? seen.crossing.t : common_place(crossings, seen.crossing.t);
  hit.shape = seen.shape;
  hit.face = seen.crossing.face;
  hit.entering = seen.crossing.entering;
  hit.solid = row.solid;
  hit.material = material_of(row, hit.face);
  place(shapes, row, state.ray.at(hit.t), hit);
  hit.shading_normal = row.smooth ? smooth_normal(row, state.ray.direction, hit) : hit.normal;
  hit.bent = row.smooth && hit.shading_normal != hit.normal;
  hit.moved = !has_not_moved(state, seen.crossing.t_error, hit);

  hit.nesting_before = state.nesting;
  hit.beside.clear();
  if (!single) add_beside(shapes, crossings, hit);
  if (hit.t == 0.0) keep_contacts(state.contacts, hit);

  hit.medium_before = medium_of(shapes, hit.nesting_before);
  hit.medium_after = medium_behind(shapes, row, hit);
  return !row.medium.valid() || hit.medium_before != hit.medium_after;
}

} // namespace abbe
