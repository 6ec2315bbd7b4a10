#pragma once

#include "core/scene/scene.h"

namespace abbe::stress {

/// A length that tells how large a scene is: the largest extent of the box around its bounded
/// shapes, its lamps and its eye.
[[nodiscard]] double size_of(const Scene& scene);

/// The same scene in other numbers: all of its coordinates and lengths in scene units are `scale`
/// times as large, and it is moved by `offset` then. The length of a unit is made up for, so that
/// what is given in millimetres stays as it is, and so do lights whose strength falls with the
/// square of the distance. The picture is the same but for rounding.
[[nodiscard]] Scene moved_scene(Scene scene, double scale, const dvec3& offset);

} // namespace abbe::stress
