// Materials of a scene's own by name, and mixtures of two:
//
//   defaultMaterials diffuse 0.3 0.1 0.05   defMaterial rust
//   metal Fe                                defMaterial bare
//   mix rust bare 0.7                       ! seven tenths are rust

#include "io/libraries/read_glass.h"
#include "io/scene_language/read_scene_state.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace abbe {
namespace {

void read_def_material(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a material");
  const auto known = std::find_if(state.named.begin(), state.named.end(), [&](const auto& named) {
    return same_name(named.name, name.text);
  });
  if (known != state.named.end())
    known->material = state.material;
  else
    state.named.push_back({name.text, state.material});
}

void read_mix(SceneState& state, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  const CurrentMaterial first =
      named_material(state, where, arguments.name_token("the name of a material"));
  const CurrentMaterial second =
      named_material(state, where, arguments.name_token("the name of a material"));
  Mixture mixture;
  mixture.share = arguments.number({"the share of the first material", 0.0, 1.0});
  const bool lets_in = is_transparent(first.finish), other = is_transparent(second.finish);
  const bool pane = first.finish.pane.has_value(), other_pane = second.finish.pane.has_value();
  if (lets_in && other && pane != other_pane)
    throw ReadError(where, "thinGlass does not mix with glass",
                    "the one bends no light and the other does",
                    "Mix it with another thinGlass, or with a material that lets no light in");
  if (lets_in && other && !pane && !same(first.medium, second.medium))
    throw ReadError(where, "the two materials would fill a solid differently",
                    "both let light in, and a solid has one filling",
                    "Mix materials of the same glass, or one that lets no light in");
  CurrentMaterial mixed{{}, lets_in ? first.medium : second.medium};
  if (!lets_in && !other) mixed.medium = CurrentMaterial{}.medium;
  mixed.finish.name = fmt::format("{} and {}", first.finish.name, second.finish.name);
  mixed.finish.transparency = Curve::constant(lets_in || other ? 1.0 : 0.0);
  mixture.first = material_id(state.scene, filled_pane(where, first));
  mixture.second = material_id(state.scene, filled_pane(where, second));
  mixed.finish.mixture = mixture;
  state.material = mixed;
}

constexpr std::array kKeywords{
    SceneKeyword{"defMaterial NAME", read_def_material, true},
    SceneKeyword{"mix FIRST SECOND share", read_mix, true},
};

} // namespace

CurrentMaterial named_material(SceneState& state, const SourcePosition& where, const Token& name) {
  for (const NamedMaterial& named : state.named)
    if (same_name(named.name, name.text)) return named.material;
  const LibraryMaterial& entry = look_up_material(state.libraries, name, state.warn);
  if (entry.glass) warn_of_extrapolation(state, where, *entry.glass);
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
  return kKeywords;
}

} // namespace abbe
