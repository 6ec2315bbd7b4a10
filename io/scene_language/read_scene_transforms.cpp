// The current transform applies to the shapes and lights that follow; the statement nearest to the
// shape acts on it first:
//
//   push
//     translate 0 0 5
//     rotate 45 0 1 0      ! degrees about an axis
//     scale 2 1 1
//     cube
//   pop

#include "geometry/rays/largest_component.h"
#include "io/scene_language/read_scene_state.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

void apply(SceneState& state, const Transform& next) {
  state.transform = state.transform.after(next);
  const dvec3 origin = state.transform.point(dvec3(0.0));
  if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(origin.z))
    throw std::invalid_argument("a transform that moves beyond the range of numbers");
}

void read_push(SceneState& state, Arguments& arguments) {
  state.pushed.push_back({state.transform, arguments.keyword().where});
}

void read_pop(SceneState& state, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  if (state.boolean && state.pushed.size() == state.boolean->push_depth)
    throw ReadError(where, "pop has no push inside " + std::string(state.boolean->keyword),
                    "the operands of a boolean have their own push and pop",
                    "Add a push after " + std::string(state.boolean->keyword));
  if (state.pushed.empty())
    throw ReadError(where, "pop has no push", "no transform is left to return to",
                    "Remove it, or add a push before");
  state.transform = state.pushed.back().transform;
  state.pushed.pop_back();
}

void read_translate(SceneState& state, Arguments& arguments) {
  apply(state, Transform::translation(arguments.vector()));
}

void read_rotate(SceneState& state, Arguments& arguments) {
  const double angle_deg = arguments.number();
  const SourcePosition where = arguments.reader().peek().where;
  const dvec3 axis = arguments.vector();
  const double size = largest_component(axis);
  if (size == 0.0)
    throw ReadError(where, "the axis of rotate has no direction", "it is 0 0 0",
                    "Give an axis such as 0 1 0");
  apply(state, Transform::rotation(angle_deg, axis / size));
}

void read_scale(SceneState& state, Arguments& arguments) {
  dvec3 factors;
  for (int i = 0; i < 3; ++i) {
    const SourcePosition where = arguments.reader().peek().where;
    factors[i] = arguments.number();
    if (factors[i] == 0.0)
      throw ReadError(where, "a factor of scale is 0",
                      "a flattened shape has no inside and no way back",
                      "Give a factor other than 0");
  }
  apply(state, Transform::scaling(factors));
}

constexpr std::array kTransformKeywords{
    SceneKeyword{"push", read_push, true},
    SceneKeyword{"pop", read_pop, true},
    SceneKeyword{"translate x y z", read_translate, true},
    SceneKeyword{"rotate angle ax ay az", read_rotate, true},
    SceneKeyword{"scale sx sy sz", read_scale, true},
};

} // namespace

std::span<const SceneKeyword> transform_keywords() {
  return kTransformKeywords;
}

} // namespace abbe
