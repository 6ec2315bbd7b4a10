// Names by which layers of a picture know things (docs/layers.md):
//
//   objectName lens   sphere   objectName none
//   lightGroup key    light D65  1 2 0  1

#include "io/scene_language/read_scene_state.h"

#include <array>

namespace abbe {
namespace {

/// A name, or "" for the word none.
std::string name_or_none(Arguments& arguments, const char* what) {
  const Token token = arguments.name_token(what);
  return is_word(token, "none") ? std::string() : token.text;
}

void read_object_name(SceneState& state, Arguments& arguments) {
  state.object_name = name_or_none(arguments, "the name of the shapes that follow, or none");
}

void read_light_group(SceneState& state, Arguments& arguments) {
  state.light.group = name_or_none(arguments, "the group of the lights that follow, or none");
}

constexpr std::array kNameKeywords{
    SceneKeyword{"objectName NAME|none", read_object_name},
    SceneKeyword{"lightGroup NAME|none", read_light_group},
};

} // namespace

std::span<const SceneKeyword> name_keywords() {
  return kNameKeywords;
}

} // namespace abbe
