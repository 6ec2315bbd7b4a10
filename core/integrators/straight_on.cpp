#include "core/integrators/straight_on.h"

namespace abbe {

void go_straight_on(Bundle& bundle) {
  const Hit& hit = bundle.hit;
  if (!bundle.straight_on) bundle.passage = {};
  bundle.straight_on = true;
  bundle.unseen_length += hit.t;
  bundle.path_length += hit.t;
  bundle.separation += bundle.divergence * hit.t;
  bundle.kind = RayKind::refracted;
  // Where the ray cannot go on, it meets nothing.
  bundle.traced = !bundle.passage.go_through(hit, bundle.state);
  if (bundle.traced) bundle.hit.shape = {};
}

} // namespace abbe
