#include "geometry/world/shape_at_place.h"

#include "geometry/rays/largest_component.h"

#include <cmath>
#include <type_traits>
#include <vector>

namespace abbe {
namespace {

/// True for a crossing that rounding cannot tell from the ray's origin.
bool is_here(const Root& root) {
  return std::abs(root.t) <= root.t_error;
}

/// At an edge the ray may both enter and leave: it has left then.
Departure behind(const Interval& part) {
  if (is_here(part.exit)) return {part.exit.face, false};
  if (is_here(part.enter)) return {part.enter.face, true};
  return {std::nullopt, part.enter.t < 0.0 && part.exit.t > 0.0};
}

template <FlatShape S>
Departure departure_from(const S& shape, const LocalRay& ray) {
  const auto root = intersect(shape, ray);
  if (!root || !is_here(*root)) return {};
  return {root->face, ray.direction.z < 0.0};
}

template <ConvexSolid S>
Departure departure_from(const S& solid, const LocalRay& ray) {
  const std::optional<Interval> part = intersect(solid, ray, nullptr);
  return part ? behind(*part) : Departure{};
}

Departure departure_from(const CsgTree& tree, const LocalRay& ray) {
  std::vector<Interval> parts;
  intersect(tree, ray, {}, parts);
  Departure found;
  for (const Interval& part : parts) {
    const Departure here = behind(part);
    if (here.inside) return here; // where two parts touch, the ray goes into the second
    if (here.face) found = here;
  }
  return found;
}

Departure departure_from(const Mesh& mesh, const LocalRay& ray) {
  const MeshCrossings first = first_crossings(mesh, ray, {}, MeshSearch::either);
  if (mesh.is_closed()) {
    const bool inside = first_crossings(mesh, ray, {}, MeshSearch::sum).exits_less_entries > 0;
    const Root& crossed = inside ? first.enter : first.exit;
    if (crossed.t != kInfinity && is_here(crossed)) return {crossed.face, inside};
    return {std::nullopt, inside};
  }
  const bool entering = first.enter.t <= first.exit.t;
  const Root& crossed = entering ? first.enter : first.exit;
  if (crossed.t == kInfinity || !is_here(crossed)) return {};
  return {crossed.face, entering};
}

} // namespace

Departure departure(const PlacedShape& placed, const Ray& ray, double place_error) {
  const LocalRay in_world{ray.origin, ray.direction, place_error, 0.0};
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (std::is_same_v<S, CsgTree>)
          return departure_from(shape, in_world); // its leaves are placed in the world already
        else
          return departure_from(shape, local_ray(placed.to_world, in_world));
      },
      placed.shape);
}

/// A point of the surface is a sum of the shape's offset and of three products, each rounded a few
/// times. No term is larger than the offset, or than the shape's distance from its frame's origin
/// after the map.
double surface_error(const PlacedShape& placed) {
  const double extent = is_bounded(placed.shape) ? bounds(placed).largest_coordinate() : 0.0;
  return 16.0 * kRoundoff * (largest_component(placed.to_world.offset()) + extent);
}

} // namespace abbe
