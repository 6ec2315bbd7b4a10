// A boolean is followed by its two operands, each with its own push, transforms and pop, and each
// a solid or again a boolean:
//
//   lens
//     sphere
//     push
//     translate 1 0 0
//     sphere
//     pop
//
// It is complete when it has both operands and every push after its keyword has its pop.

#include "io/scene_language/read_scene_state.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace abbe {
namespace {

constexpr int kDeepestBoolean =
    200; ///< booleans inside each other; more would exhaust the call stack

bool is_complete(const SceneState& state, const BooleanScope& scope) {
  return scope.operands.size() == 2 && state.pushed.size() == scope.push_depth;
}

int depth_of(const SceneState& state) {
  return state.boolean ? state.boolean->depth + 1 : 1;
}

/// Reads the operands of one boolean, which may be others.
CsgTree read_operands(SceneState& state, const Arguments& arguments, CsgOperation operation,
                      const Medium* filling) {
  BooleanScope* const outer = state.boolean;
  const SourcePosition& where = arguments.keyword().where;
  BooleanScope scope;
  scope.keyword = arguments.name();
  scope.where = where;
  scope.material = state.material;
  scope.whole = outer ? outer->whole : state.builder.add_material(where, state.material);
  scope.filling = filling;
  scope.push_depth = state.pushed.size();
  scope.depth = depth_of(state);
  if (scope.depth > kDeepestBoolean)
    throw ReadError(where, "too many booleans inside each other",
                    fmt::format("at most {} are read", kDeepestBoolean), "Combine fewer solids");

  state.boolean = &scope;
  while (!is_complete(state, scope))
    read_statement(state, arguments.reader());
  state.boolean = outer;
  return {operation, std::move(scope.operands[0]), std::move(scope.operands[1])};
}

template <CsgOperation operation>
void read_boolean(SceneState& state, Arguments& arguments) {
  if (BooleanScope* const outer = state.boolean) {
    outer->operands.push_back(read_operands(state, arguments, operation, outer->filling));
    state.material = outer->material;
    return;
  }
  // The tree's frame is the transform at the keyword; inside, transforms count from there.
  const Transform to_world = std::exchange(state.transform, Transform());
  const CurrentMaterial whole = state.material;
  const Medium* const filling = is_transparent(whole.finish) ? &whole.medium : nullptr;
  CsgTree tree = read_operands(state, arguments, operation, filling);
  place_shape(state, arguments.keyword().where, std::move(tree), to_world, whole);
  state.transform = to_world.after(state.transform);
}

constexpr std::array kBooleanKeywords{
    SceneKeyword{"lens", read_boolean<CsgOperation::intersect>, true},
    SceneKeyword{"intersection", read_boolean<CsgOperation::intersect>, true},
    SceneKeyword{"union", read_boolean<CsgOperation::unite>, true},
    SceneKeyword{"difference", read_boolean<CsgOperation::subtract>, true},
};

} // namespace

MaterialId operand_finish(SceneState& state, const SourcePosition& where) {
  const BooleanScope& scope = *state.boolean;
  const CurrentMaterial& own = state.material;
  check_surface(where, own.finish);
  state.builder.keywords().meet_shape(own, true);
  check_solid(state.builder.scene(), where, own.finish);
  const bool other_filling =
      is_transparent(own.finish) && scope.filling && own.medium != *scope.filling;
  if (other_filling)
    warn_at(state, where,
            "what fills this operand is ignored (one medium fills the whole solid, that of the "
            "outermost boolean)");
  const MaterialId id = state.builder.add_material(where, own);
  return id == scope.whole ? MaterialId{} : id;
}

void add_operand(SceneState& state, CsgTree tree) {
  state.boolean->operands.push_back(std::move(tree));
  state.material = state.boolean->material;
}

void check_operands(const SceneState& state, const Token& next) {
  const BooleanScope& scope = *state.boolean;
  if (is_complete(state, scope))
    throw ReadError(
        next.where, fmt::format("{} stands after both operands of {}", shown(next), scope.keyword),
        fmt::format("the boolean at line {} is complete before what brings its operands",
                    scope.where.line),
        fmt::format("Move it out of there, or {} into it", scope.keyword));
  if (scope.operands.size() == 2) {
    if (is_word(next, "pop")) return;
    throw ReadError(
        next.where, fmt::format("{} stands where pop should", shown(next)),
        fmt::format("{} at line {} has both operands, but not every push inside it has its pop",
                    scope.keyword, scope.where.line),
        "Add the pop");
  }
  if (next.kind == TokenKind::end)
    throw ReadError(
        scope.where, fmt::format("{} lacks an operand", scope.keyword),
        fmt::format("{} ends after {} of 2 solids", ending(next), scope.operands.size()),
        "Add a solid after it");
}

std::span<const SceneKeyword> boolean_keywords() {
  return kBooleanKeywords;
}

} // namespace abbe
