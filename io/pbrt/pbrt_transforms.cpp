#include "io/pbrt/pbrt_statement.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <numbers>

namespace abbe {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

void multiply(const Statement& s, const dmat4& m) {
  s.state.now.transform = s.state.now.transform * m;
}

/// The matrix from the world to a camera that looks along its +z with +y up and +x to the right.
dmat4 look_at(const Statement& s) {
  const auto n = s.numbers<9>();
  const dvec3 eye(n[0], n[1], n[2]), to(n[3], n[4], n[5]), up(n[6], n[7], n[8]);
  const dvec3 view = to - eye, right = glm::cross(up, view);
  if (!(glm::length(view) > 0.0 && glm::length(right) > 0.0))
    throw ReadError(s.where, "LookAt tells no direction",
                    "the points are the same, or up points along the view", "Change one of them");
  const dvec3 x = glm::normalize(right), z = glm::normalize(view), y = glm::cross(z, x);
  return glm::inverse(dmat4(dvec4(x, 0.0), dvec4(y, 0.0), dvec4(z, 0.0), dvec4(eye, 1.0)));
}

dmat4 matrix_of(const std::array<double, 16>& n) { // pbrt gives column after column
  dmat4 m;
  for (int i = 0; i < 16; ++i)
    m[i / 4][i % 4] = n[static_cast<std::size_t>(i)];
  return m;
}

void read_translate(const Statement& s) {
  const auto n = s.numbers<3>();
  multiply(s, glm::translate(dmat4(1.0), dvec3(n[0], n[1], n[2])));
}
void read_scale(const Statement& s) {
  const auto n = s.numbers<3>();
  multiply(s, glm::scale(dmat4(1.0), dvec3(n[0], n[1], n[2])));
}
void read_rotate(const Statement& s) {
  const auto n = s.numbers<4>();
  const dvec3 axis(n[1], n[2], n[3]);
  if (!(glm::length(axis) > 0.0))
    throw ReadError(s.where, "Rotate has no axis", "it is 0 0 0", "Give an axis such as 0 1 0");
  multiply(s, glm::rotate(dmat4(1.0), n[0] * std::numbers::pi / 180.0, axis));
}
void read_look_at(const Statement& s) {
  multiply(s, look_at(s));
}
void read_transform(const Statement& s) {
  s.state.now.transform = matrix_of(s.numbers<16>());
}
void read_concat_transform(const Statement& s) {
  multiply(s, matrix_of(s.numbers<16>()));
}
void read_identity(const Statement& s) {
  s.state.now.transform = dmat4(1.0);
}
void read_coordinate_system(const Statement& s) {
  s.state.coordinate_systems[s.string()] = s.state.now.transform;
}
void read_coord_sys_transform(const Statement& s) {
  const std::string name = s.string();
  const auto found = s.state.coordinate_systems.find(name);
  if (found == s.state.coordinate_systems.end())
    throw ReadError(s.where, fmt::format("unknown coordinate system \"{}\"", name),
                    "no CoordinateSystem of this name has been given before", "Check the name");
  s.state.now.transform = found->second;
}

constexpr std::array kTransforms{
    Directive{"Translate", read_translate},
    Directive{"Scale", read_scale},
    Directive{"Rotate", read_rotate},
    Directive{"LookAt", read_look_at},
    Directive{"Transform", read_transform},
    Directive{"ConcatTransform", read_concat_transform},
    Directive{"Identity", read_identity},
    Directive{"CoordinateSystem", read_coordinate_system},
    Directive{"CoordSysTransform", read_coord_sys_transform},
};

} // namespace

std::span<const Directive> pbrt_transforms() {
  return kTransforms;
}

} // namespace abbe
