// Where shapes go, and lenses that are given as two caps of balls:
//
//   Translate 0 0 -1.8  Shape "sphere" "float radius" 2 "float zmin" 1.8
//   Translate 0 0  3.6  Shape "sphere" "float radius" 2 "float zmax" -1.8
//
// pbrt has no solids: light is inside of glass where it has passed one surface. Here a shape of
// glass is a solid, so the caps become what is enclosed between them.

#include "io/pbrt/pbrt_state.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

Transform transform_of(const SourcePosition& where, const dmat4& m) {
  try {
    return {glm::dmat3(m), dvec3(m[3])};
  } catch (const std::invalid_argument& fault) {
    throw ReadError(where, "the current transform cannot be undone", fault.what(),
                    "Give a transform that keeps volumes");
  }
}

/// Rims that are printed with six digits meet.
bool same_rim(const PbrtCap& a, const PbrtCap& b) {
  constexpr double kPrinted = 1e-5;
  const double most = kPrinted * a.rim_radius;
  return glm::length(a.rim_centre - b.rim_centre) <= most &&
         std::abs(a.rim_radius - b.rim_radius) <= most;
}

bool holds(const PbrtCap& ball, const dvec3& point) {
  return glm::length(dvec3(glm::inverse(ball.to_world) * dvec4(point, 1.0))) <= 1.0;
}

/// What two caps enclose. Caps on both sides of the rim's plane are the common part of their balls,
/// or all of both where each cap lies outside of the other's ball; caps on one side are what the
/// more curved ball has alone.
CsgTree enclosed(const PbrtCap& a, const PbrtCap& b) {
  const bool one_side = glm::dot(a.apex - a.rim_centre, b.apex - b.rim_centre) > 0.0;
  const auto leaf = [](const PbrtCap& cap) {
    return CsgTree(Sphere{}, transform_of(cap.where, cap.to_world));
  };
  if (!one_side)
    return {holds(b, a.apex) ? CsgOperation::intersect : CsgOperation::unite, leaf(a), leaf(b)};
  const bool a_beyond = glm::length(a.apex - a.rim_centre) > glm::length(b.apex - b.rim_centre);
  return {CsgOperation::subtract, leaf(a_beyond ? a : b), leaf(a_beyond ? b : a)};
}

} // namespace

void join_caps(PbrtState& state) {
  std::vector<PbrtCap> caps = std::exchange(state.caps, {});
  while (!caps.empty()) {
    const PbrtCap cap = std::move(caps.back());
    caps.pop_back();
    const auto other =
        std::ranges::find_if(caps, [&](const PbrtCap& c) { return same_rim(c, cap); });
    if (other == caps.end()) {
      refuse(state, cap.where, "a part of a sphere of glass",
             "no other one shares its rim, so that it encloses nothing");
      continue;
    }
    const CsgTree lens = enclosed(*other, cap).moved(transform_of(cap.where, state.to_ours));
    state.builder.add_shape(other->where, {lens, Transform(), {}, {}, 0}, other->material);
    caps.erase(other);
  }
}

void place_pbrt_shape(PbrtState& state, const SourcePosition& where, Shape shape,
                      const dmat4& to_world, const ShapeMaterial& material) {
  if (state.open_object) {
    state.objects[*state.open_object].push_back({where, std::move(shape), to_world, material});
    return;
  }
  state.builder.add_shape(
      where, {std::move(shape), transform_of(where, state.to_ours * to_world), {}, {}, 0},
      material);
}

} // namespace abbe
