#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/ray.h"
#include "geometry/rays/short_vector.h"

namespace abbe {

/// A surface on which a ray's origin lies, and the side of the shape to which the ray goes. The
/// outside of a flat shape is where its normal points.
struct SurfaceContact {
  ShapeId shape;
  FaceId face;
  Side side = Side::outside;
  friend bool operator==(const SurfaceContact&, const SurfaceContact&) = default;
};

/// All surfaces that meet at a ray's origin: one as a rule, more where solids touch. The first is
/// the one that shows, and its side always holds. The sides of the others hold unless the ray's
/// direction contradicts them: a ray in a corner of two walls crosses the second one at once.
using Contacts = ShortVector<SurfaceContact, 2>;

/// The solids that contain a ray's origin, in the order in which they were entered.
using Nesting = ShortVector<ShapeId, 4>;

/// A ray, with the surfaces that its origin lies on and the solids that it is inside of. Solvers go
/// by these identities, where a tolerance would guess.
struct RayState {
  Ray ray; ///< in world coordinates; `direction` has unit length
  Contacts contacts;
  Nesting nesting;
};

/// A surface beside the one that shows, at the same place.
struct SurfaceBeside {
  ShapeId shape;
  FaceId face;
  Side from = Side::outside; ///< the side of the shape that the ray came from
  bool crossed = true;       ///< false: the ray only lies on it, and stays on that side
  bool solid = false;        ///< the shape has an inside
};

/// What a ray meets next, if anything. Nearly always this is one surface, and the ray is in one
/// solid at most: whatever else may be there is kept apart, so that a hit is short and quick to
/// copy.
struct Hit {
  Hit() {} // not `= default`: value-initialization would clear the lists' storage first

  [[nodiscard]] bool met() const { return shape.valid(); }

  double t = 0.0;    ///< distance from the ray's origin
  dvec3 point{0.0};  ///< on the surface
  dvec3 normal{0.0}; ///< unit, outwards from the shape
  /// What light is reflected and refracted by: `normal`, but on a mesh with normals of its own,
  /// where the ray runs through both in the same sense.
  dvec3 shading_normal{0.0};
  ShapeId shape;       ///< the shape that shows
  FaceId face;         ///< the part of the shape that shows
  MaterialId material; ///< the material of that part
  MediumId medium_before, medium_after;
  bool entering = true; ///< the ray runs against `normal` and `shading_normal`
  bool moved = true;    ///< false: rounding cannot tell the point from the ray's origin
  bool bent = false;    ///< the surface is shaded by another normal than its own
  bool solid = false;   ///< the shape has an inside
  /// The solids before the boundary. They are not always those of the ray, which may have passed
  /// boundaries that do not show.
  Nesting nesting_before;
  ShortVector<SurfaceBeside, 1> beside; ///< surfaces that coincide with the one that shows

  /// The two normals, against the ray.
  [[nodiscard]] dvec3 facing_normal() const { return entering ? normal : -normal; }
  [[nodiscard]] dvec3 facing_shading_normal() const {
    return entering ? shading_normal : -shading_normal;
  }

  /// Where a ray that goes on from the point is then: which surfaces it lies on, and which solids
  /// it is inside of. `through` tells whether it goes through the surface or leaves on the side
  /// that it came from.
  void go_on(bool through, Contacts& contacts, Nesting& nesting) const {
    contacts.assign({shape, face, entering != through ? Side::outside : Side::inside});
    nesting = nesting_before;
    if (through && solid) enter_or_leave(nesting, shape, entering);
    if (!beside.empty()) [[unlikely]]
      go_on_beside(through, contacts, nesting);
  }
  /// The same as a ray in this direction.
  [[nodiscard]] RayState going_on(const dvec3& direction, bool through) const {
    RayState state{{point, direction}, {}, {}};
    go_on(through, state.contacts, state.nesting);
    return state;
  }
  /// The solids behind the boundary.
  [[nodiscard]] Nesting nesting_after() const {
    Contacts contacts;
    Nesting nesting;
    go_on(true, contacts, nesting);
    return nesting;
  }

private:
  static void enter_or_leave(Nesting& nesting, ShapeId shape, bool entering) {
    std::size_t i = 0;
    while (i < nesting.size() && nesting[i] != shape)
      ++i;
    const bool found = i < nesting.size();
    if (entering && !found) nesting.push_back(shape);
    if (!entering && found) nesting.erase(i);
  }
  void go_on_beside(bool through, Contacts& contacts, Nesting& nesting) const;
};

} // namespace abbe
