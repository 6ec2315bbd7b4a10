#include "geometry/rays/ray_state.h"

namespace abbe {

void Hit::go_on_beside(bool through, Contacts& contacts, Nesting& nesting) const {
  for (const SurfaceBeside& other : beside) {
    const bool crossed = through && other.crossed;
    const bool outside = (other.from == Side::outside) != crossed;
    contacts.push_back({other.shape, other.face, outside ? Side::outside : Side::inside});
    if (crossed && other.solid) enter_or_leave(nesting, other.shape, other.from == Side::outside);
  }
}

} // namespace abbe
