#include "geometry/meshes/close_mesh.h"

#include "geometry/meshes/orient_parts.h"
#include "geometry/meshes/seams.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace abbe {
namespace {

/// Seams of this part of a mesh's diagonal are taken for rounding, such as that of single
/// precision or of six printed digits.
constexpr double kSeam = 1e-6;

double diagonal(const Mesh& mesh) {
  const Bounds box = bounds(mesh, Transform());
  return glm::length(box.upper - box.lower);
}

Mesh turned(const Mesh& mesh, const std::vector<bool>& turn) {
  std::vector<Triangle> triangles = mesh.triangles();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (turn[t]) std::swap(triangles[t][1], triangles[t][2]);
  return {mesh.vertices(), triangles};
}

/// One way of mending; the mesh is as given where it stays open.
MendedMesh mended_by(const Mesh& mesh, Repetition dropped) {
  const double tolerance = kSeam * diagonal(mesh);
  SewnMesh base = mesh.is_closed() ? SewnMesh{mesh} : sewn(mesh, tolerance, dropped);
  const PartOrientation found = orient_parts(base.mesh);
  const OpenMesh open{found.open_edges, found.open_from, found.open_to, found.one_sided};
  if (found.open_edges > 0 || found.one_sided) return {mesh, open};
  const auto count =
      static_cast<std::size_t>(std::count(found.turn.begin(), found.turn.end(), true));
  if (count > 0) base.mesh = turned(base.mesh, found.turn);
  if (!base.mesh.is_closed()) return {mesh, open}; // some triangle comes twice
  return {base.mesh, {}, base.repeated, base.welded, base.split, count, tolerance};
}

} // namespace

MendedMesh close_mesh(const Mesh& mesh) {
  // Two bodies that touch may hold one triangle twice, in opposite senses. What is alike is dropped
  // only where it stands in the way.
  MendedMesh first = mended_by(mesh, Repetition::none);
  if (first.mesh.is_closed()) return first;
  for (const Repetition dropped : {Repetition::same_sense, Repetition::any_sense}) {
    const std::vector<bool> again = repeated(mesh.triangles(), dropped);
    if (std::ranges::find(again, true) == again.end()) continue;
    MendedMesh mended = mended_by(mesh, dropped);
    if (mended.mesh.is_closed()) return mended;
    if (first.open.edges == 0) first.open = mended.open;
  }
  return first;
}

} // namespace abbe
