#pragma once

#include "core/scene/scene.h"
#include "io/text/read_error.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

namespace abbe {

/// Hill's default material: a dull light grey.
[[nodiscard]] Material default_finish();

/// What a shape is made of: its surface, and what fills it where the surface lets light in.
struct ShapeMaterial {
  Material finish = default_finish();
  Medium medium{"", ThesisScaled{1.0, 0.0}, Curve::constant(0.0)};
};

/// A finish that lets all light in, and the glass behind it.
[[nodiscard]] ShapeMaterial clear_material(const Medium& filling);
[[nodiscard]] ShapeMaterial clear_glass(const Glass& glass);
/// A polished metal.
[[nodiscard]] ShapeMaterial bare_metal(const Metal& metal);

/// True when the finish lets light into the solid.
[[nodiscard]] bool is_transparent(const Material& finish);

/// Throws ReadError where a shape's finish has parts that do not go together: a film without a
/// boundary of glass or metal below it, or a coat on one.
void check_surface(const SourcePosition& where, const Material& finish);

/// Throws ReadError where the finish of a solid is a pane, or one of the materials that it mixes,
/// which are those of `scene`.
void check_solid(const Scene& scene, const SourcePosition& where, const Material& finish);

/// The finish of a shape: a pane is of the glass that would fill a solid. Throws ReadError where
/// that has no index.
[[nodiscard]] Material filled_pane(const SourcePosition& where, const ShapeMaterial& material);

/// Throws ReadError for a medium that cannot fill a solid: one with an index that is not above 0 at
/// every wavelength of a picture, or drops in anything but air.
void check_medium(const SourcePosition& where, const Medium& medium);

} // namespace abbe
