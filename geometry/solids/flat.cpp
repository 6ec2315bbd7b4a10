#include "geometry/solids/flat.h"

namespace abbe {

Bounds bounds(const Square&, const Transform& to_world) {
  return to_world.box({{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
}

Bounds bounds(const Disc&, const Transform& to_world) {
  return to_world.disc_box(0.0, 1.0);
}

Bounds bounds(const Plane&, const Transform&) {
  return {dvec3(-1e18), dvec3(0.9e18)};
}

} // namespace abbe
