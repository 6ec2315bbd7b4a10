// Materials of a scene's own by name, and mixtures of two:
//
//   defaultMaterials diffuse 0.3 0.1 0.05   defMaterial rust
//   metal Fe                                defMaterial bare
//   mix rust bare 0.7                       ! seven tenths are rust

#include "io/libraries/read_glass.h"
#include "io/scene_language/read_scene_state.h"

#include <fmt/format.h>

#include <array>

namespace abbe {
namespace {

void read_def_material(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a material");
  for (const NotedKeyword slot : state.material.given.slots)
    state.builder.keywords().keep(slot);
  if (const auto known = state.material_names.find(name.text)) {
    state.named[*known] = state.material;
    return;
  }
  state.material_names.add(name.text, state.named.size());
  state.named.push_back(state.material);
}

void read_mix(SceneState& state, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  const CurrentMaterial first =
      named_material(state, where, arguments.name_token("the name of a material"));
  const CurrentMaterial second =
      named_material(state, where, arguments.name_token("the name of a material"));
  const double share = arguments.number({"the share of the first material", 0.0, 1.0});
  state.material = state.builder.mix(where, first, second, share);
}

constexpr std::array kMixtureKeywords{
    SceneKeyword{"defMaterial NAME", read_def_material, true},
    SceneKeyword{"mix FIRST SECOND share", read_mix, true},
};

} // namespace

CurrentMaterial named_material(SceneState& state, const SourcePosition& where, const Token& name) {
  if (const auto known = state.material_names.find(name.text)) return state.named[*known];
  const LibraryMaterial& entry = look_up_material(state.libraries, name, state.warn);
  if (entry.glass) state.builder.warn_of_extrapolation(where, *entry.glass, state.warn);
  return {finish(entry), filling(entry)};
}

void require_unmixed(const SceneState& state, const Arguments& arguments) {
  if (!state.material.finish.mixture) return;
  throw ReadError(arguments.keyword().where,
                  fmt::format("{} does not go with mix", arguments.name()),
                  "its two materials have finishes of their own",
                  "Change them before they are mixed, or begin again with defaultMaterials");
}

std::span<const SceneKeyword> mixture_keywords() {
  return kMixtureKeywords;
}

} // namespace abbe
