// Wavefront's OBJ: a statement a line.
//
//   # a square
//   v -1 -1 0
//   v 1 -1 0
//   v 1 1 0
//   v -1 1 0
//   f 1 2 3 4
//
// Vertices count from 1; -1 is the last one before the face. A corner may also be v/vt, v//vn or
// v/vt/vn. A backslash at the end of a line goes on with the next.

#include "io/meshes/read_obj.h"

#include "io/meshes/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace abbe {
namespace {

/// Statements that say nothing of where a surface is.
constexpr std::array<std::string_view, 37> kLeftOut{
    "vt",     "vp",     "g",     "o",     "s",        "mg",       "usemtl",     "mtllib",
    "usemap", "maplib", "lod",   "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj",
    "cstype", "deg",    "bmat",  "step",  "ctech",    "stech",    "parm",       "trim",
    "hole",   "scrv",   "sp",    "end",   "con",      "call",     "csh",        "p",
    "l",      "curv",   "curv2", "vc",    "",
};

class ObjReader {
public:
  ObjReader(std::string_view text, const std::filesystem::path& file, const Warn& warn)
      : text_(text, file, {.comments = true, .continued = true}), warn_(warn) {}

  Polygons read() {
    do {
      const std::size_t place = text_.offset();
      const std::string_view keyword = text_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "vn")
        read_normal();
      else if (keyword == "f" || keyword == "fo")
        read_face();
      else if (std::ranges::find(kLeftOut, keyword) == kLeftOut.end() && left_out_++ == 0)
        first_left_out_ = place;
    } while (text_.next_line());
    require_vertices();
    if (polygons_.normals.empty()) polygons_.corner_normals.clear();
    if (polygons_.corner_normals.empty()) polygons_.normals.clear(); // no corner names one
    if (left_out_ > 0)
      warn_(fmt::format("{}: {} is left out (it is no statement that makes a mesh){}",
                        to_string(text_.position(first_left_out_)),
                        text_.shown_word(first_left_out_),
                        left_out_ > 1 ? fmt::format(", and {} more like it", left_out_ - 1) : ""));
    return std::move(polygons_);
  }

private:
  /// Three coordinates. A weight or a colour may follow.
  void read_vertex() {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i)
      p[i] = text_.number("a coordinate");
    while (!text_.line_is_done())
      text_.number("a number");
    if (polygons_.vertices.size() == std::numeric_limits<std::int32_t>::max())
      throw ReadError(text_.file(), "it holds more than 2147483647 vertices",
                      "a mesh can hold no more", "Cut it into several files");
    polygons_.vertices.push_back(p);
  }

  void read_normal() {
    glm::vec3 n;
    for (int i = 0; i < 3; ++i)
      n[i] = text_.single_number("a component of a normal");
    polygons_.normals.push_back(n);
  }

  void read_face() {
    const std::size_t begin = polygons_.corners.size();
    while (!text_.line_is_done())
      polygons_.corners.push_back(read_corner());
    if (const std::size_t count = polygons_.corners.size() - begin; count < 3)
      throw text_.error(text_.offset(), fmt::format("the face ends after {} corners", count),
                        "a face has three or more", "Write the mesh again");
    polygons_.ends.push_back(polygons_.corners.size());
  }

  /// Returns the number of the vertex, which counts from 0 and may come later in the file.
  std::int32_t read_corner() {
    const std::size_t place = text_.offset();
    const std::int64_t number = text_.leading_whole_number("the number of a vertex");
    const auto known = static_cast<std::int64_t>(polygons_.vertices.size());
    if (number == 0 || number < -known || number > std::numeric_limits<std::int32_t>::max())
      fail_vertex(place);
    if (number > farthest_) {
      farthest_ = number;
      farthest_place_ = place;
    }
    const std::int32_t normal = read_texture_and_normal(place);
    if (normal >= 0) polygons_.corner_normals.resize(polygons_.corners.size(), -1);
    if (normal >= 0 || !polygons_.corner_normals.empty())
      polygons_.corner_normals.push_back(normal);
    return static_cast<std::int32_t>(number > 0 ? number - 1 : known + number);
  }

  /// Returns the number of the normal, which counts from 0; -1: none.
  std::int32_t read_texture_and_normal(std::size_t place) {
    const auto number_follows = [&] { return !text_.word_ends() && !text_.stands('/'); };
    if (text_.take('/') && number_follows()) text_.leading_whole_number("the number of a vertex");
    std::int32_t normal = -1;
    if (text_.take('/')) normal = read_normal_number(place);
    if (!text_.word_ends())
      throw text_.error(place, fmt::format("{} is no corner", text_.shown_word(place)),
                        "corners are v, v/vt, v//vn or v/vt/vn", "Write the mesh again");
    return normal;
  }

  std::int32_t read_normal_number(std::size_t place) {
    const std::int64_t number = text_.leading_whole_number("the number of a normal");
    const auto known = static_cast<std::int64_t>(polygons_.normals.size());
    if (number == 0 || number < -known || number > std::numeric_limits<std::int32_t>::max()) {
      if (known == 0) return -1; // programs that leave normals out may go on naming them
      fail_normal(place);
    }
    if (number > farthest_normal_) {
      farthest_normal_ = number;
      farthest_normal_place_ = place;
    }
    return static_cast<std::int32_t>(number > 0 ? number - 1 : known + number);
  }

  void require_vertices() const {
    if (farthest_ > static_cast<std::int64_t>(polygons_.vertices.size()))
      fail_vertex(farthest_place_);
    if (!polygons_.normals.empty() &&
        farthest_normal_ > static_cast<std::int64_t>(polygons_.normals.size()))
      fail_normal(farthest_normal_place_);
  }

  [[noreturn]] void fail_normal(std::size_t place) const {
    throw text_.error(place, fmt::format("{} names no normal", text_.shown_word(place)),
                      fmt::format("there are {} normals up to here, and they count from 1",
                                  polygons_.normals.size()),
                      "Write the mesh again");
  }

  [[noreturn]] void fail_vertex(std::size_t place) const {
    throw text_.error(place, fmt::format("{} names no vertex", text_.shown_word(place)),
                      fmt::format("there are {} vertices up to here, and they count from 1",
                                  polygons_.vertices.size()),
                      "Write the mesh again");
  }

  MeshText text_;
  const Warn& warn_;
  Polygons polygons_;
  std::int64_t farthest_ = 0; ///< the highest number of a vertex that a face has named
  std::size_t farthest_place_ = 0;
  std::int64_t farthest_normal_ = 0; ///< the same of normals
  std::size_t farthest_normal_place_ = 0;
  std::size_t left_out_ = 0, first_left_out_ = 0;
};

} // namespace

Polygons read_obj(std::string_view text, const std::filesystem::path& file, const Warn& warn) {
  return ObjReader(text, file, warn).read();
}

} // namespace abbe
