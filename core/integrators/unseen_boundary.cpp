#include "core/integrators/unseen_boundary.h"

namespace abbe {

void pass_unseen_boundary(Bundle& bundle, const World& world, Passage& passage, RayCounts& counts) {
  Hit& hit = bundle.hit;
  if (!passage.go_through(hit, bundle.state)) { // no way leads on
    hit.shape = {};
    return;
  }
  bundle.passed += hit.t;
  bundle.path_length += hit.t;
  bundle.position_spread += bundle.direction_spread * hit.t;
  world.find_closest(bundle.state, kInfinity, passage, bundle.hit);
  counts.add(RayKind::refracted, bundle.state);
}

} // namespace abbe
