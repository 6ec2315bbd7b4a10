#pragma once

#include "geometry/meshes/mesh.h"

#include <optional>

namespace abbe {

/// A place where bodies of a closed mesh overlap, or one body goes through itself: just inside of
/// some triangle, and inside more than once. It is looked for beside a few hundred triangles, so
/// that small overlaps are not found. Bodies that touch, and hollows, are no overlaps.
[[nodiscard]] std::optional<dvec3> find_overlap(const Mesh& mesh);

} // namespace abbe
