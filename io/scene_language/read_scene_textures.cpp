// Patterns and images on surfaces, in place of one diffuse colour:
//
//   checker 8 8  0.8 0.8 0.8  0.1 0.1 0.1     ! 8 by 8 fields
//   grid 20 20 0.1  0.05 0.05 0.05  0.9 0.9 0.9
//   imageTexture tiles.png

#include "io/images/read_image.h"
#include "io/scene_language/read_scene_state.h"
#include "spectral/rgb_spectrum.h"

#include <fmt/format.h>

#include <array>

namespace abbe {
namespace {

constexpr Range kFields{"a number of fields", 0.0, std::numeric_limits<double>::infinity(), true};
constexpr Range kWidth{"the breadth of a line in fields", 0.0, 1.0};

/// Three numbers, or a material's diffuse part.
Curve read_diffuse(SceneState& state, Arguments& arguments) {
  if (arguments.number_follows()) return rgb_reflectance(read_fraction_rgb(state, arguments));
  const Token name = arguments.name_token("a colour or the name of a material");
  const Material finish = named_material(state, arguments.keyword().where, name).finish;
  if (finish.texture || finish.mixture)
    throw ReadError(name.where, shown(name) + " has no single diffuse colour",
                    finish.mixture ? "it is a mixture" : "it has a texture",
                    "Name a material with one, or give three numbers");
  return finish.diffuse;
}

void read_checker(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  CheckerTexture checker;
  checker.across = arguments.number(kFields);
  checker.up = arguments.number(kFields);
  checker.first = read_diffuse(state, arguments);
  checker.second = read_diffuse(state, arguments);
  state.material.finish.texture = checker;
}

void read_grid(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  GridTexture grid;
  grid.across = arguments.number(kFields);
  grid.up = arguments.number(kFields);
  grid.width = arguments.number(kWidth);
  grid.lines = read_diffuse(state, arguments);
  grid.fields = read_diffuse(state, arguments);
  state.material.finish.texture = grid;
}

/// A file is read once.
void read_image_texture(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  const Token name = arguments.name_token("the name of a file");
  add_input(state.files, name);
  std::error_code error;
  const auto path = std::filesystem::weakly_canonical(image_path(name), error);
  const std::size_t image =
      state.builder.add_image(path, [&] { return read_image(name, state.warn); });
  state.material.finish.texture = ImageTexture{image};
}

constexpr std::array kTextureKeywords{
    SceneKeyword{"checker nu nv FIRST SECOND", read_checker, true},
    SceneKeyword{"grid nu nv width LINES FIELDS", read_grid, true},
    SceneKeyword{"imageTexture FILE", read_image_texture, true},
};

} // namespace

std::span<const SceneKeyword> texture_keywords() {
  return kTextureKeywords;
}

} // namespace abbe
