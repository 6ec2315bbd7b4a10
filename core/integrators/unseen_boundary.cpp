#include "core/integrators/unseen_boundary.h"

namespace abbe {

void pass_unseen_boundary(Bundle& bundle) {
  const Hit& hit = bundle.hit;
  if (!bundle.straight_on) bundle.passage = {};
  bundle.straight_on = true;
  bundle.unseen_length += hit.t;
  bundle.path_length += hit.t;
  bundle.separation += bundle.divergence * hit.t;
  bundle.kind = RayKind::refracted;
  // Where no way leads on, the ray meets nothing.
  bundle.traced = !bundle.passage.go_through(hit, bundle.state);
  if (bundle.traced) bundle.hit.shape = {};
}

} // namespace abbe
