// The Stanford polygon format: a header in text says what follows, in text or in bytes.
//
//   ply
//   format ascii 1.0
//   element vertex 3
//   property float x
//   property float y
//   property float z
//   element face 1
//   property list uchar int vertex_indices
//   end_header
//   0 0 0
//   1 0 0
//   0 1 0
//   3 0 1 2
//
// Instead of faces there may be "tristrips": lists in which each three numbers in a row are a
// triangle, every other one turned round, and -1 begins a new strip.

#include "io/meshes/read_ply.h"

#include "io/meshes/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace abbe {
namespace {

/// What the rows of an element are to us.
enum class Kind { vertex, face, strips, other };

Kind kind_of(const PlyElement& element) {
  if (element.name == "vertex") return Kind::vertex;
  if (element.name == "face") return Kind::face;
  if (element.name == "tristrips") return Kind::strips;
  return Kind::other;
}

bool is_list_of_vertices(const PlyProperty& property) {
  return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// nx, ny or nz.
bool is_normal(const PlyProperty& property) {
  return property.name.size() == 2 && property.name[0] == 'n' && property.name[1] >= 'x' &&
         property.name[1] <= 'z';
}

bool has_normals(const PlyElement& element) {
  return std::ranges::count_if(element.properties, is_normal) == 3;
}

/// Throws unless there is one element of vertices with coordinates, and faces and strips have lists
/// of them. Returns how many vertices there are.
std::int64_t require_elements(const PlyHeader& header, const std::filesystem::path& file) {
  const auto fail = [&](const std::string& what, const std::string& why) {
    return ReadError(file, what, why, "Write the mesh again");
  };
  std::optional<std::uint64_t> vertices;
  for (const PlyElement& element : header.elements) {
    const auto count = [&](const auto& wanted) {
      return std::ranges::count_if(element.properties, wanted);
    };
    switch (kind_of(element)) {
    case Kind::vertex:
      if (vertices)
        throw fail("its header declares vertices twice", "there may be one such element");
      vertices = element.count;
      for (const char* axis : {"x", "y", "z"})
        if (count([&](const PlyProperty& p) { return p.name == axis && !p.length; }) != 1)
          throw fail(fmt::format("its vertices have no coordinate {}", axis),
                     "each has one x, one y and one z");
      break;
    case Kind::face:
    case Kind::strips:
      if (count(is_list_of_vertices) != 1)
        throw fail(fmt::format("its element {} has no corners", element.name),
                   "it has one list vertex_indices or vertex_index");
      break;
    case Kind::other:
      break;
    }
  }
  if (!vertices) throw fail("it has no vertices", "its header declares no element \"vertex\"");
  if (*vertices > std::numeric_limits<std::int32_t>::max())
    throw fail(fmt::format("it declares {} vertices", *vertices),
               "a mesh can hold no more than 2147483647");
  return static_cast<std::int64_t>(*vertices);
}

template <class Values>
class BodyReader {
public:
  BodyReader(Values& values, std::int64_t vertex_count)
      : values_(values), vertex_count_(vertex_count) {}

  Polygons read(const std::vector<PlyElement>& elements) {
    for (const PlyElement& element : elements)
      read_element(element);
    values_.end_file();
    return std::move(polygons_);
  }

private:
  void read_element(const PlyElement& element) {
    if (element.properties.empty()) return; // rows of nothing
    require_room(element);
    const Kind kind = kind_of(element);
    if (kind == Kind::vertex) polygons_.vertices.reserve(element.count);
    if (kind == Kind::face) polygons_.ends.reserve(element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (!values_.begin_row())
        throw values_.error(values_.place(), holds(element, fmt::format("{}", row)),
                            "it is cut off, or its header is wrong");
      read_row(element, kind);
      values_.end_row();
    }
  }

  /// Before anything is allocated: the rest of the file must be able to hold what is declared.
  void require_room(const PlyElement& element) const {
    std::uint64_t row_bytes = 0;
    for (const PlyProperty& property : element.properties)
      row_bytes += byte_count(property.length.value_or(property.type));
    if (!values_.can_hold_rows(element.count, element.properties.size(), row_bytes))
      throw values_.error(values_.place(), holds(element, "fewer"),
                          "it is cut off, or its header is wrong");
  }

  static std::string holds(const PlyElement& element, const std::string& what) {
    return fmt::format("the file declares {} rows of element {} and holds {}", element.count,
                       element.name, what);
  }

  void read_row(const PlyElement& element, Kind kind) {
    glm::dvec3 p(0.0);
    glm::vec3 n(0.0f);
    for (const PlyProperty& property : element.properties) {
      if (kind == Kind::vertex && !property.length && property.name.size() == 1 &&
          property.name[0] >= 'x' && property.name[0] <= 'z')
        p[property.name[0] - 'x'] = coordinate(property.type);
      else if (kind == Kind::vertex && !property.length && is_normal(property))
        n[property.name[1] - 'x'] = static_cast<float>(values_.value(property.type));
      else if ((kind == Kind::face || kind == Kind::strips) && is_list_of_vertices(property))
        read_corners(property, kind == Kind::strips);
      else
        values_.skip(property.type, property.length ? length(property) : 1);
    }
    if (kind == Kind::vertex) polygons_.vertices.push_back(p);
    if (kind == Kind::vertex && has_normals(element)) polygons_.normals.push_back(n);
  }

  double coordinate(PlyType type) {
    const std::size_t place = values_.place();
    const double value = values_.value(type);
    if (!std::isfinite(value))
      throw values_.error(place, "a coordinate is no finite number", "a vertex has a place");
    return value;
  }

  std::uint64_t length(const PlyProperty& list) {
    const std::size_t place = values_.place();
    const double length = values_.value(*list.length);
    if (length < 0.0)
      throw values_.error(place, fmt::format("a list has {} values", length), "it is below 0");
    const auto count = static_cast<std::uint64_t>(length);
    if (!values_.can_hold(list.type, count))
      throw values_.error(place,
                          fmt::format("a list declares {} values and the file holds fewer", count),
                          "it is cut off, or damaged here");
    return count;
  }

  void read_corners(const PlyProperty& list, bool strips) {
    const std::uint64_t count = length(list);
    std::size_t in_strip = 0; // how many corners the strip has so far
    std::array<std::int32_t, 2> before{};
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::optional<std::int32_t> corner = vertex_number(list.type, strips);
      if (!strips) {
        polygons_.corners.push_back(*corner);
      } else if (!corner) {
        in_strip = 0;
      } else {
        if (in_strip >= 2) {
          const bool turned = in_strip % 2 == 1;
          polygons_.corners.insert(polygons_.corners.end(),
                                   {before[turned ? 1 : 0], before[turned ? 0 : 1], *corner});
          polygons_.ends.push_back(polygons_.corners.size());
        }
        before = {before[1], *corner};
        ++in_strip;
      }
    }
    if (!strips) polygons_.ends.push_back(polygons_.corners.size());
  }

  /// Nothing for the -1 that ends a strip.
  std::optional<std::int32_t> vertex_number(PlyType type, bool strips) {
    const std::size_t place = values_.place();
    const double number = values_.value(type);
    if (strips && number == -1.0) return std::nullopt;
    if (!(number >= 0.0 && number < static_cast<double>(vertex_count_)) ||
        number != std::floor(number))
      throw values_.error(
          place, fmt::format("a face has vertex {} for a corner", number),
          fmt::format("there are {} vertices, and they count from 0", vertex_count_));
    return static_cast<std::int32_t>(number);
  }

  Values& values_;
  std::int64_t vertex_count_;
  Polygons polygons_;
};

} // namespace

Polygons read_ply(std::string_view bytes, const std::filesystem::path& file) {
  MeshText text(bytes, file, {});
  const PlyHeader header = read_ply_header(text);
  const std::int64_t vertices = require_elements(header, file);
  if (header.format == PlyFormat::text) {
    PlyTextValues values(text);
    return BodyReader(values, vertices).read(header.elements);
  }
  PlyByteValues values(text.rest(), bytes.size() - text.rest().size(),
                       header.format == PlyFormat::big_endian, file);
  return BodyReader(values, vertices).read(header.elements);
}

} // namespace abbe
