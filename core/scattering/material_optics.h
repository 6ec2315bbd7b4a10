#pragma once

#include "core/bundles/path_wavelengths.h"
#include "core/optics/surface_optics.h"

namespace abbe {

/// The optics of a planned material between two media, at the path's wavelengths. For a coated
/// material they are those of the coat's upper side. Valid until the path's wavelengths change.
[[nodiscard]] SurfaceOptics material_optics(const MaterialPlan& material, MediumId before,
                                            MediumId after, PathWavelengths& wavelengths);

} // namespace abbe
