#pragma once

#include "geometry/rays/frame.h"
#include "geometry/rays/passage.h"
#include "geometry/world/boundary.h"
#include "geometry/world/world_embree.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

namespace abbe {

/// What a callback needs of a shape, close together in memory.
struct Primitive {
  Primitive(const PlacedShape& shape, ShapeId number)
      : frame(shape.to_world), placed(&shape), id(number), glass(shape.medium.valid()) {}

  Frame frame;
  const PlacedShape* placed;
  ShapeId id;
  bool glass;
};

/// One Embree geometry holds all shapes of one type, so a callback need not ask for the type.
struct ShapeGroup {
  std::vector<Primitive> primitives; ///< by Embree's number
  double padding = 0.0;              ///< what bounds grow by, for the float error of Embree's rays
};
/// One group for each type of Shape, in the order of the variant.
using ShapeGroups = std::array<ShapeGroup, std::variant_size_v<Shape>>;

/// What the callbacks know of the rays that are traced. It is passed through Embree's context,
/// which must be the first member. A ray's number in `states` and `found` is its Embree id.
struct Query {
  embree::Context context;
  const RayState* states = nullptr;
  NearestCandidates* found = nullptr; ///< for closest hits
  double farthest_coordinate = 0.0;   ///< what the bounds are padded for
  double distance = kInfinity;        ///< only what is surely nearer counts
  bool glass_may_hide = false; ///< for occlusion: glass is no answer, only noted in `met_glass`
  bool met_glass = false;
  const Passage* passage = nullptr; ///< of a ray that is followed straight on
};

/// A float not less than `value`.
[[nodiscard]] inline float rounded_up(double value) {
  const float near = static_cast<float>(value);
  if (near == std::numeric_limits<float>::infinity()) return near;
  // The bits of the next float are the next integer; nextafter would be a function call.
  return near > 0.0f ? std::bit_cast<float>(std::bit_cast<std::uint32_t>(near) + 1)
                     : std::nextafter(near, std::numeric_limits<float>::infinity());
}

/// Makes a geometry of every group that has shapes and attaches it. The groups must stay where
/// they are.
void attach(const ShapeGroups& groups, RTCDevice device, RTCScene scene);

} // namespace abbe
