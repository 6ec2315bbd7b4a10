#pragma once

#include "geometry/rays/ray_state.h"

#include <algorithm>

namespace abbe {

/// What a ray that is followed straight on, boundary after boundary, must remember: the faces that
/// it has crossed where it is now, once it crosses a second boundary at one place. A contact names
/// one face of a shape. At a corner of a mesh that the ray only touches, one face would be found
/// again while another one is crossed, for ever. Faces that have been crossed are not asked again
/// until the ray has moved.
class Passage {
public:
  /// Moves the ray behind what it has met. Returns false where the ray cannot go on: without having
  /// moved, it has crossed faces again in the same sense, twice in turn. So every walk ends, since
  /// the ray moves or the faces at its place are used up.
  [[nodiscard]] bool go_through(const Hit& hit, RayState& state) {
    if (!hit.moved) return go_through_at_one_place(hit, state);
    crossed_.clear(); // the contacts alone say what the ray has crossed
    repeats_ = false;
    state.ray.origin = hit.point;
    hit.go_on(true, state.contacts, state.nesting);
    return true;
  }

  /// The faces that the ray has crossed at its origin, with the side of the shape that it came to.
  /// Empty where they are no more than its contacts.
  [[nodiscard]] const Contacts& crossed() const { return crossed_; }

private:
  [[gnu::noinline]] bool go_through_at_one_place(const Hit& hit, RayState& state) {
    if (crossed_.empty()) crossed_ = state.contacts;
    const RayState behind = hit.going_on(state.ray.direction, true);
    const bool again =
        std::find(crossed_.begin(), crossed_.end(), behind.contacts[0]) != crossed_.end();
    if (again && repeats_) return false;
    repeats_ = again;
    for (const SurfaceContact& contact : behind.contacts)
      crossed_.push_back(contact);
    state = behind;
    return true;
  }

  Contacts crossed_;
  bool repeats_ = false; ///< the last face was crossed again
};

} // namespace abbe
