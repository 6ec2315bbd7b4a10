#include "core/integrators/unseen_boundary.h"

namespace abbe {

void pass_unseen_boundary(Bundle& bundle) {
  const Hit& hit = bundle.hit;
  bundle.state.ray.origin = hit.point;
  bundle.state.contacts = hit.other_side;
  bundle.state.nesting = hit.nesting_after;
  bundle.unseen_length += hit.t;
  bundle.path_length += hit.t;
  bundle.separation += bundle.divergence * hit.t;
  bundle.kind = RayKind::refracted;
  bundle.traced = false;
}

} // namespace abbe
