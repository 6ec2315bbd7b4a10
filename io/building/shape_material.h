#pragma once

#include "core/scene/scene.h"
#include "io/text/read_error.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abbe {

/// A statement of a scene, by its number in a KeywordLedger; negative: none.
struct NotedKeyword {
  std::int32_t number = -1;
};

/// One statement in each slot.
template <class Slot>
struct NotedKeywords {
  std::array<NotedKeyword, static_cast<std::size_t>(Slot::count)> slots{};
  [[nodiscard]] NotedKeyword& operator[](Slot slot) {
    return slots[static_cast<std::size_t>(slot)];
  }
  [[nodiscard]] const NotedKeyword& operator[](Slot slot) const {
    return slots[static_cast<std::size_t>(slot)];
  }
};

/// What statements may have set of the current material, and of the lights that follow.
enum class MaterialSlot : std::uint8_t {
  roughness,
  compensation,
  film,
  reflectivity,
  specular_exponent,
  emissive_sides,
  fresnel,
  index,
  vnum,
  dispersion_scale,
  absorption,
  drops,
  count
};
enum class LightSlot : std::uint8_t { falloff, intensity, soft_edge, sun_radius, count };
using LightKeywords = NotedKeywords<LightSlot>;

/// Hill's default material: a dull light grey.
[[nodiscard]] Material default_finish();

/// What a shape is made of: its surface, and what fills it where the surface lets light in.
struct ShapeMaterial {
  Material finish = default_finish();
  Medium medium{"", ThesisScaled{1.0, 0.0}, Curve::constant(0.0)};
  /// Where ambient and diffuse are still Hill's defaults. A transparent body has none of these.
  bool default_ambient = false, default_diffuse = false;
  NotedKeywords<MaterialSlot> given{}; ///< the statements that it comes from, as far as noted
};

/// What shapes are made of when a scene begins.
[[nodiscard]] ShapeMaterial default_material();

/// A finish that lets all light in, and the glass behind it.
[[nodiscard]] ShapeMaterial clear_material(const Medium& filling);
[[nodiscard]] ShapeMaterial clear_glass(const Glass& glass);
/// A polished metal.
[[nodiscard]] ShapeMaterial bare_metal(const Metal& metal);

/// True when the finish lets light into the solid.
[[nodiscard]] bool is_transparent(const Material& finish);

/// True when the material needs a solid to fill: light is bent at its surface, or reflected by the
/// index of what is behind. A pane has its own index, and needs none; nor does a surface whose
/// shares stand by themselves, or behind which the index stays 1. The materials that it mixes are
/// those of `scene`.
[[nodiscard]] bool needs_inside(const Scene& scene, const ShapeMaterial& material);

/// Throws ReadError where a shape's finish has parts that do not go together: a film without a
/// boundary of glass or metal below it, or a coat on one.
void check_surface(const SourcePosition& where, const Material& finish);

/// Throws ReadError where the finish of a solid is a pane, or one of the materials that it mixes,
/// which are those of `scene`.
void check_solid(const Scene& scene, const SourcePosition& where, const Material& finish);

/// Throws ReadError where the material of a shape without an inside needs one.
void check_sheet(const Scene& scene, const SourcePosition& where, const ShapeMaterial& material);

/// The finish of a shape: a pane is of the glass that would fill a solid, and a transparent body
/// has no ambient and diffuse part that nobody has given it. Throws ReadError where a pane's glass
/// has no index.
[[nodiscard]] Material shape_finish(const SourcePosition& where, const ShapeMaterial& material);

/// Throws ReadError for a medium that cannot fill a solid: one with an index that is not above 0 at
/// every wavelength of a picture, or drops in anything but air.
void check_medium(const SourcePosition& where, const Medium& medium);

} // namespace abbe
