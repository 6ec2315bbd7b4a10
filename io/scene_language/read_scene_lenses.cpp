// Lenses by the data of a prescription, about the z axis; light travels along +z, and a radius
// above 0 has its centre on that side:
//
//   glass N-SF11
//   lensElement 19.93 0  7  25.4                ! front and back radius, thickness, diameter
//
//   cemented 2 25.4                             ! elements and their diameter, then in turn
//     33.34  N-BAF10 9  -22.28  SF10 2.5  -291.07     ! radius, glass, thickness, radius ...

#include "geometry/booleans/lens.h"
#include "io/libraries/read_glass.h"
#include "io/scene_language/read_scene_state.h"

#include <array>
#include <stdexcept>

namespace abbe {
namespace {

constexpr Range kThickness{.meaning = "the thickness on the axis", .open = true};
constexpr Range kDiameter{.meaning = "the diameter", .open = true};

/// 0 and `inf` are flat.
double read_radius(Arguments& arguments) {
  if (!is_word(arguments.reader().peek(), "inf")) return arguments.number();
  arguments.reader().next();
  return 0.0;
}

CsgTree checked(const LensElement& lens, const SourcePosition& where, MaterialId material = {}) {
  try {
    return lens_element(lens, material);
  } catch (const std::invalid_argument& error) {
    throw ReadError(where, "these data describe no lens", error.what(),
                    "Check the signs of the radii, the thickness and the diameter");
  }
}

void read_lens_element(SceneState& state, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  LensElement lens;
  lens.front_radius = read_radius(arguments);
  lens.back_radius = read_radius(arguments);
  lens.thickness = arguments.number(kThickness);
  lens.diameter = arguments.number(kDiameter);
  if (arguments.number_follows()) lens.front_vertex = arguments.number();
  if (state.boolean)
    add_operand(state, checked(lens, where, operand_finish(state, where)).moved(state.transform));
  else
    place_shape(state, where, checked(lens, where), state.transform, state.material);
}

void read_cemented(SceneState& state, Arguments& arguments) {
  const auto count = arguments.whole_number({"the number of elements", 2, 16});
  LensElement lens;
  lens.diameter = arguments.number(kDiameter);
  lens.back_radius = read_radius(arguments);
  lens.thickness = 0.0; // the first vertex is at z = 0
  for (std::int64_t i = 0; i < count; ++i) {
    const SourcePosition where = arguments.reader().peek().where;
    const CurrentMaterial material = read_clear_glass(state, arguments);
    lens.front_vertex = lens.back_vertex();
    lens.front_radius = lens.back_radius;
    lens.thickness = arguments.number(kThickness);
    lens.back_radius = read_radius(arguments);
    place_shape(state, where, checked(lens, where), state.transform, material);
  }
}

constexpr std::array kLensKeywords{
    SceneKeyword{"lensElement R1 R2 thickness diameter [z]", read_lens_element, true},
    SceneKeyword{"cemented n diameter R1 GLASS thickness R2 ...", read_cemented},
};

} // namespace

std::span<const SceneKeyword> lens_keywords() {
  return kLensKeywords;
}

} // namespace abbe
