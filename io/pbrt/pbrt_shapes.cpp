// Shapes, in the frame of the current transform:
//
//   Shape "sphere" "float radius" 2 "float zmin" 1.8
//   Shape "trianglemesh" "point3 P" [ ... ] "integer indices" [ 0 1 2  0 2 3 ]

#include "geometry/meshes/close_mesh.h"
#include "io/meshes/match_normals.h"
#include "io/meshes/read_mesh.h"
#include "io/pbrt/pbrt_state.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

dvec3 moved(const dmat4& m, const dvec3& p) {
  return dvec3(m * dvec4(p, 1.0));
}

/// The material that a shape has now: the current one, with light of its own where it is an area
/// light, and with what the medium inside takes.
ShapeMaterial current(const PbrtState& state) {
  ShapeMaterial material = state.now.material->shape;
  if (state.now.emission) {
    material.finish.emission = *state.now.emission;
    material.finish.emits_behind = state.now.two_sided;
  }
  if (const auto medium = state.media.find(state.now.inside); medium != state.media.end())
    material.medium.absorption_per_mm = medium->second.absorption;
  return material;
}

bool fills(const PbrtState& state) {
  return state.now.material->fills;
}

/// Four corners of two triangles, u and v going from 0 to 1 along its edges.
struct Parallelogram {
  dvec3 corner, along_u, along_v;
};

/// A parallelogram as the square from -1 to 1 whose +z is on the side of `normal`.
dmat4 square_place(Parallelogram p, const dvec3& normal, bool may_swap) {
  if (may_swap && glm::dot(glm::cross(p.along_u, p.along_v), normal) < 0.0)
    std::swap(p.along_u, p.along_v);
  const dvec3 u = 0.5 * p.along_u, v = 0.5 * p.along_v;
  // Any third axis will do that is as long as the square, for a transform that can be inverted.
  const dvec3 across = glm::cross(u, v);
  const double size = std::sqrt(glm::length(across));
  return {dvec4(u, 0.0), dvec4(v, 0.0), dvec4(across / glm::length(across) * size, 0.0),
          dvec4(p.corner + u + v, 1.0)};
}

/// The triangles of a mesh as pbrt gives them.
struct TriangleList {
  std::vector<dvec3> points;
  std::vector<Triangle> triangles;
  std::vector<dvec2> uv;          ///< one for each point, or none
  std::vector<glm::vec3> normals; ///< likewise
};

/// Nothing unless the mesh is two triangles that make one parallelogram, with u and v that fill it
/// or none at all.
std::optional<Parallelogram> as_parallelogram(const TriangleList& mesh) {
  if (mesh.triangles.size() != 2 || mesh.points.size() != 4 || !mesh.normals.empty())
    return std::nullopt;
  const auto point = [&](std::int32_t i) { return mesh.points[static_cast<std::size_t>(i)]; };
  // The corner of each triangle that the other one has not, and the two that they share.
  const Triangle &a = mesh.triangles[0], &b = mesh.triangles[1];
  std::int32_t alone = -1, opposite = -1;
  for (const std::int32_t i : a)
    if (std::ranges::find(b, i) == b.end()) alone = alone < 0 ? i : -2;
  for (const std::int32_t i : b)
    if (std::ranges::find(a, i) == a.end()) opposite = opposite < 0 ? i : -2;
  if (alone < 0 || opposite < 0) return std::nullopt;
  std::array<std::int32_t, 2> shared{};
  std::size_t count = 0;
  for (const std::int32_t i : a)
    if (i != alone && count < 2) shared[count++] = i;
  const dvec3 gap = point(alone) + point(opposite) - point(shared[0]) - point(shared[1]);
  const double size = glm::length(point(alone) - point(opposite));
  if (!(glm::length(gap) <= 1e-6 * size)) return std::nullopt; // six printed digits
  if (mesh.uv.empty())
    return Parallelogram{point(alone), point(shared[0]) - point(alone),
                         point(shared[1]) - point(alone)};
  const auto with_uv = [&](double u, double v) -> std::int32_t {
    for (std::size_t i = 0; i < 4; ++i)
      if (mesh.uv[i] == dvec2(u, v)) return static_cast<std::int32_t>(i);
    return -1;
  };
  const std::int32_t zero = with_uv(0, 0), u = with_uv(1, 0), v = with_uv(0, 1);
  if (zero < 0 || u < 0 || v < 0 || with_uv(1, 1) < 0) return std::nullopt;
  // The two corners that a third one lies between must not face each other.
  const dvec3 far = point(u) + point(v) - point(zero) - point(with_uv(1, 1));
  if (!(glm::length(far) <= 1e-6 * size)) return std::nullopt;
  return Parallelogram{point(zero), point(u) - point(zero), point(v) - point(zero)};
}

dvec3 normal_of(const TriangleList& mesh) {
  const auto at = [&](std::size_t i) {
    return mesh.points[static_cast<std::size_t>(mesh.triangles[0][i])];
  };
  return glm::cross(at(1) - at(0), at(2) - at(0));
}

/// Adds triangles as a square where they are one, or as a mesh.
void add_triangles(PbrtState& state, const SourcePosition& where, TriangleList mesh) {
  const ShapeMaterial material = current(state);
  if (state.now.reversed)
    for (Triangle& t : mesh.triangles)
      std::swap(t[1], t[2]);
  const bool textured = material.finish.texture.has_value();
  const auto square = as_parallelogram(mesh);
  if (square && !fills(state)) {
    const bool one_sided = state.now.emission && !state.now.two_sided;
    const dmat4 place = square_place(*square, normal_of(mesh), !textured);
    if (one_sided && glm::dot(dvec3(place[2]), normal_of(mesh)) < 0.0)
      refuse(state, where, "a textured light whose u and v run clockwise",
             "it would shine on its other side");
    return place_pbrt_shape(state, where, Square{}, state.now.transform * place, material);
  }
  if (textured)
    refuse(state, where, "a texture on a mesh",
           "u and v are known on spheres, disks and parallelograms");
  Polygons polygons;
  polygons.vertices = std::move(mesh.points);
  polygons.normals = std::move(mesh.normals);
  const CutPolygons cut{mesh.triangles,
                        polygons.normals.empty() ? std::vector<Triangle>{} : mesh.triangles};
  try {
    const Mesh plain(polygons.vertices, cut.triangles);
    if (!fills(state))
      return place_pbrt_shape(state, where, with_normals(plain, polygons, cut), state.now.transform,
                              material);
    const MendedMesh mended = close_mesh(plain);
    if (!mended.mesh.is_closed()) throw open_mesh_error(where, mended.open);
    place_pbrt_shape(state, where, with_normals(mended.mesh, polygons, cut), state.now.transform,
                     material);
  } catch (const std::invalid_argument& fault) {
    throw ReadError(where, "the mesh holds no surface", fault.what(),
                    "Give triangles with an area");
  }
}

TriangleList read_points(const SourcePosition& where, PbrtParameters& parameters) {
  TriangleList mesh;
  auto points = parameters.points("P");
  if (!points || points->empty())
    throw ReadError(where, "a mesh has no points", "they are its point3 P", "Add them");
  mesh.points = std::move(*points);
  if (const auto normals = parameters.points("N"); normals && normals->size() == mesh.points.size())
    for (const dvec3& n : *normals)
      mesh.normals.emplace_back(n);
  const std::vector<double> uv = parameters.numbers("uv");
  if (uv.size() == 2 * mesh.points.size())
    for (std::size_t i = 0; i < uv.size(); i += 2)
      mesh.uv.emplace_back(uv[i], uv[i + 1]);
  parameters.ignore({"S"});
  return mesh;
}

std::int32_t corner(const SourcePosition& where, double index, std::size_t points) {
  if (!(index >= 0.0 && index < static_cast<double>(points)) || index != std::floor(index))
    throw ReadError(where, fmt::format("{} names no point of the mesh", index),
                    fmt::format("there are {} points, and they count from 0", points),
                    "Check the indices");
  return static_cast<std::int32_t>(index);
}

void read_triangle_mesh(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  TriangleList mesh = read_points(where, parameters);
  std::vector<double> indices = parameters.numbers("indices");
  if (indices.empty() && mesh.points.size() == 3) indices = {0.0, 1.0, 2.0};
  if (indices.empty() || indices.size() % 3 != 0)
    throw ReadError(where, "a mesh has no triangles",
                    fmt::format("{} indices are not three for each", indices.size()),
                    "Give three indices for each triangle");
  for (std::size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.push_back({corner(where, indices[i], mesh.points.size()),
                              corner(where, indices[i + 1], mesh.points.size()),
                              corner(where, indices[i + 2], mesh.points.size())});
  add_triangles(state, where, std::move(mesh));
}

/// Patches of four corners: two triangles each. A patch that is not flat is refused.
void read_bilinear_mesh(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  TriangleList mesh = read_points(where, parameters);
  std::vector<double> indices = parameters.numbers("indices");
  if (indices.empty()) indices = {0.0, 1.0, 2.0, 3.0};
  if (indices.size() % 4 != 0)
    throw ReadError(where, "a bilinear mesh has four indices for each patch",
                    fmt::format("{} indices follow", indices.size()), "Check the indices");
  if (mesh.uv.empty() && mesh.points.size() == 4)
    mesh.uv = {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1), dvec2(1, 1)};
  for (std::size_t i = 0; i < indices.size(); i += 4) {
    std::array<std::int32_t, 4> c{};
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = corner(where, indices[i + k], mesh.points.size());
    const auto p = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(c[k])]; };
    const dvec3 across = glm::cross(p(1) - p(0), p(2) - p(0));
    if (std::abs(glm::dot(p(3) - p(0), across)) >
        1e-6 * glm::length(across) * glm::length(p(3) - p(0)))
      refuse(state, where, "a bilinear patch that is not flat", "flat ones are read");
    mesh.triangles.push_back({c[0], c[1], c[3]});
    mesh.triangles.push_back({c[0], c[3], c[2]});
  }
  add_triangles(state, where, std::move(mesh));
}

void read_ply_mesh(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  const std::string name = parameters.string("filename", "");
  const std::filesystem::path file = state.folder / name;
  const auto format = mesh_format(file);
  if (format != MeshFormat::ply)
    throw ReadError(where, fmt::format("\"{}\" is no PLY file", name),
                    "its name ends neither in .ply nor in .ply.gz", "Give such a file");
  parameters.ignore({"displacement", "edgelength"});
  state.files.push_back(file);
  try {
    const MendedMesh read = mesh_of(mesh_bytes(file), file, *format, state.warn);
    if (fills(state) && !read.mesh.is_closed()) throw open_mesh_error(where, read.open);
    if (state.now.reversed && !read.mesh.is_closed())
      refuse(state, where, "ReverseOrientation of an open PLY mesh",
             "its triangles have the sides of the file");
    if (current(state).finish.texture)
      refuse(state, where, "a texture on a mesh",
             "u and v are known on spheres, disks and parallelograms");
    place_pbrt_shape(state, where, read.mesh, state.now.transform, current(state));
  } catch (const std::invalid_argument& fault) {
    throw ReadError(where, fmt::format("\"{}\" holds no surface", file.string()), fault.what(),
                    "Give a file with triangles or polygons");
  } catch (const ReadError&) {
    throw;
  } catch (const std::runtime_error& fault) {
    throw ReadError(where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Give a file that can be read");
  }
}

void require_whole_turn(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  if (parameters.number("phimax", 360.0) < 360.0)
    refuse(state, where, "a part of a turn (phimax)", "whole ones are read");
}

void read_sphere(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  const double radius = parameters.number("radius", 1.0);
  if (!(radius > 0.0))
    throw ReadError(where, "a sphere has no radius", "it is above 0", "Give a radius");
  const double low = std::max(parameters.number("zmin", -radius), -radius);
  const double high = std::min(parameters.number("zmax", radius), radius);
  require_whole_turn(state, where, parameters);
  const dmat4 ball = state.now.transform * glm::scale(dmat4(1.0), dvec3(radius));
  if (low <= -radius && high >= radius)
    return place_pbrt_shape(state, where, Sphere{}, ball, current(state));
  const bool upper = high >= radius, lower = low <= -radius;
  if (!fills(state) || !(upper || lower) || !(low < high) || state.open_object)
    return refuse(state, where, "a part of a sphere",
                  "whole ones are read, and two caps of glass that share a rim");
  const double rim = upper ? low : high;
  PbrtCap cap{where,
              ball,
              moved(state.now.transform, {0.0, 0.0, rim}),
              moved(state.now.transform, {0.0, 0.0, upper ? radius : -radius}),
              glm::length(dvec3(state.now.transform *
                                dvec4(std::sqrt(radius * radius - rim * rim), 0.0, 0.0, 0.0))),
              current(state)};
  state.caps.push_back(std::move(cap));
}

void read_disk(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  const double radius = parameters.number("radius", 1.0);
  const double height = parameters.number("height", 0.0);
  require_whole_turn(state, where, parameters);
  if (parameters.number("innerradius", 0.0) > 0.0)
    refuse(state, where, "a disk with a hole", "whole ones are read");
  if (!(radius > 0.0))
    throw ReadError(where, "a disk has no radius", "it is above 0", "Give a radius");
  const double side = state.now.reversed ? -1.0 : 1.0; // turned about x, so that +z is -z
  const dmat4 place = glm::translate(dmat4(1.0), dvec3(0.0, 0.0, height)) *
                      glm::scale(dmat4(1.0), dvec3(radius, side * radius, side * radius));
  place_pbrt_shape(state, where, Disc{}, state.now.transform * place, current(state));
}

/// pbrt's cylinder has no ends. Opaque, it looks like one with ends from outside only.
void read_cylinder(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters) {
  const double radius = parameters.number("radius", 1.0);
  const double low = parameters.number("zmin", -1.0), high = parameters.number("zmax", 1.0);
  require_whole_turn(state, where, parameters);
  if (!(radius > 0.0 && high > low))
    throw ReadError(where, "a cylinder is empty", "its radius is above 0 and zmax above zmin",
                    "Check the numbers");
  refuse(state, where, "a cylinder without ends", "it would be read with both of them");
  const dmat4 place = glm::translate(dmat4(1.0), dvec3(0.0, 0.0, low)) *
                      glm::scale(dmat4(1.0), dvec3(radius, radius, high - low));
  place_pbrt_shape(state, where, TaperedCylinder{1.0}, state.now.transform * place, current(state));
}

} // namespace

void read_pbrt_shape(PbrtState& state, const SourcePosition& where, const std::string& type,
                     PbrtParameters& parameters) {
  if (state.now.material->nothing && !state.now.emission) return;
  if (const PbrtParameter* alpha = parameters.find("alpha");
      alpha && alpha->numbers != std::vector{1.0})
    refuse(state, alpha->where, "alpha of a shape", "shapes are whole");
  if (type == "sphere")
    read_sphere(state, where, parameters);
  else if (type == "disk")
    read_disk(state, where, parameters);
  else if (type == "cylinder")
    read_cylinder(state, where, parameters);
  else if (type == "trianglemesh")
    read_triangle_mesh(state, where, parameters);
  else if (type == "bilinearmesh")
    read_bilinear_mesh(state, where, parameters);
  else if (type == "plymesh")
    read_ply_mesh(state, where, parameters);
  else
    return refuse(state, where, fmt::format("the shape \"{}\"", type),
                  "sphere, disk, cylinder, trianglemesh, bilinearmesh and plymesh are read");
  refuse_unused(state, parameters);
}

} // namespace abbe
