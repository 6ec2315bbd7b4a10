#include "core/integrators/unseen_boundary.h"

namespace abbe {

void pass_unseen_boundary(Bundle& bundle, const World& world, RayCounts& counts) {
  const Hit& hit = bundle.hit;
  bundle.state.ray.origin = hit.point;
  bundle.state.contacts = hit.other_side;
  bundle.state.nesting = hit.nesting_after;
  bundle.passed += hit.t;
  bundle.path_length += hit.t;
  bundle.position_spread += bundle.direction_spread * hit.t;
  world.find_closest(bundle.state, bundle.hit);
  counts.add(RayKind::refracted, bundle.state);
}

} // namespace abbe
