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
    if (hit.moved) {
      crossed_.clear(); // the contacts alone say what the ray has crossed
      repeats_ = false;
    } else if (!cross_at_one_place(hit, state.contacts)) {
      return false;
    }
    state.ray.origin = hit.point;
    state.contacts = hit.other_side;
    state.nesting = hit.nesting_after;
    return true;
  }

  /// The faces that the ray has crossed at its origin, with the side of the shape that it came to.
  /// Empty where they are no more than its contacts.
  [[nodiscard]] const Contacts& crossed() const { return crossed_; }

private:
  [[gnu::noinline]] bool cross_at_one_place(const Hit& hit, const Contacts& before) {
    if (crossed_.empty()) crossed_ = before;
    const bool again =
        std::find(crossed_.begin(), crossed_.end(), hit.other_side[0]) != crossed_.end();
    if (again && repeats_) return false;
    repeats_ = again;
    for (const SurfaceContact& contact : hit.other_side)
      crossed_.push_back(contact);
    return true;
  }

  Contacts crossed_;
  bool repeats_ = false; ///< the last face was crossed again
};

} // namespace abbe
