// STL (stereolithography): triangles with their corners written out, in text
//
//   solid corner
//     facet normal 0 0 -1
//       outer loop
//         vertex 0 0 0
//         vertex 0 1 0
//         vertex 1 0 0
//       endloop
//     endfacet
//   endsolid corner
//
// or in binary, little endian: 80 bytes of anything, the number of triangles in 32 bits, and for
// each triangle 12 numbers of single precision (the normal and three corners) and 16 bits more.

#include "io/meshes/read_stl.h"

#include "io/meshes/mesh_text.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>

namespace abbe {
namespace {

constexpr std::size_t kHeader = 84, kFacet = 50, kNormal = 12, kCorner = 12; ///< in bytes

template <class Number>
Number little_endian(const char* at) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), at, bytes.size());
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return std::bit_cast<Number>(bytes);
}

/// Gives each place one vertex, whose number it tells again when the place comes again.
class VertexTable {
public:
  explicit VertexTable(std::filesystem::path file) : file_(std::move(file)) {}

  void add_corner(Polygons& polygons, const glm::dvec3& p) {
    const glm::dvec3 place = p + 0.0; // -0 is 0
    const auto number = static_cast<std::int32_t>(polygons.vertices.size());
    const auto [known, is_new] = numbers_.try_emplace(Key{std::bit_cast<std::uint64_t>(place.x),
                                                          std::bit_cast<std::uint64_t>(place.y),
                                                          std::bit_cast<std::uint64_t>(place.z)},
                                                      number);
    if (is_new) {
      if (number == std::numeric_limits<std::int32_t>::max())
        throw ReadError(file_, "it holds more than 2147483647 vertices", "a mesh can hold no more",
                        "Cut it into several files");
      polygons.vertices.push_back(place);
    }
    polygons.corners.push_back(known->second);
  }

private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t mixed = 0;
      for (const std::uint64_t word : key) {
        mixed = (mixed ^ word) * 0x9E3779B97F4A7C15U; // the golden ratio's fraction, in 64 bits
        mixed ^= mixed >> 32U;
      }
      return mixed;
    }
  };

  std::filesystem::path file_;
  std::unordered_map<Key, std::int32_t, Hash> numbers_;
};

/// What a binary file says; the bytes hold a header.
std::uint64_t declared_triangles(std::string_view bytes) {
  return little_endian<std::uint32_t>(bytes.data() + kHeader - sizeof(std::uint32_t));
}

/// Some programs begin the header of a binary file with "solid" too, so that its size decides.
bool is_binary(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kFacet * declared_triangles(bytes);
}

Polygons read_binary(std::string_view bytes, const std::filesystem::path& file) {
  Polygons polygons;
  VertexTable vertices(file);
  for (std::size_t facet = kHeader; facet < bytes.size(); facet += kFacet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at =
            facet + kNormal + kCorner * corner + sizeof(float) * static_cast<std::size_t>(axis);
        p[axis] = little_endian<float>(bytes.data() + at);
        if (!std::isfinite(p[axis]))
          throw ReadError(file, fmt::format("at byte {}, a coordinate is no finite number", at),
                          "a vertex has a place", "Write the mesh again");
      }
      vertices.add_corner(polygons, p);
    }
    polygons.ends.push_back(polygons.corners.size());
  }
  return polygons;
}

/// The statements of a text, one a line.
class StlText {
public:
  StlText(std::string_view text, const std::filesystem::path& file)
      : text_(text, file, {}), vertices_(file) {}

  Polygons read() {
    while (next_keyword()) {
      expect("solid");
      while (next_keyword() && !is("endsolid"))
        read_facet();
      if (keyword_.empty()) fail("endsolid");
    }
    return std::move(polygons_);
  }

private:
  /// The first word of the next line that has one. Returns false at the end of the file. What else
  /// stands in the line before is left out: a name or a normal.
  bool next_keyword() {
    bool more = true;
    if (begun_) more = text_.next_line();
    begun_ = true;
    while (more && text_.line_is_done())
      more = text_.next_line();
    place_ = text_.offset();
    keyword_ = more ? text_.word() : std::string_view();
    return !keyword_.empty();
  }

  [[nodiscard]] bool is(std::string_view word) const { return same_name(keyword_, word); }

  void expect(std::string_view word) const {
    if (!is(word)) fail(word);
  }

  void read_facet() {
    expect("facet");
    next_keyword();
    expect("outer");
    for (int corner = 0; corner < 3; ++corner) {
      next_keyword();
      expect("vertex");
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = text_.number("a coordinate");
      vertices_.add_corner(polygons_, p);
    }
    polygons_.ends.push_back(polygons_.corners.size());
    next_keyword();
    expect("endloop");
    next_keyword();
    expect("endfacet");
  }

  [[noreturn]] void fail(std::string_view word) const {
    if (keyword_.empty())
      throw text_.error(place_, fmt::format("the file ends where {} should stand", word),
                        "it is cut off", "Write the mesh again");
    throw text_.error(place_,
                      fmt::format("{} stands where {} should", text_.shown_word(place_), word),
                      "a facet is facet, outer loop, three times vertex, endloop, endfacet",
                      "Write the mesh again");
  }

  MeshText text_;
  VertexTable vertices_;
  Polygons polygons_;
  bool begun_ = false;
  std::size_t place_ = 0;    ///< of the keyword
  std::string_view keyword_; ///< empty at the end of the file
};

} // namespace

Polygons read_stl(std::string_view bytes, const std::filesystem::path& file) {
  if (is_binary(bytes)) return read_binary(bytes, file);
  MeshText begin(bytes, file, {});
  if (same_name(begin.word(), "solid")) return StlText(bytes, file).read();
  if (bytes.size() >= kHeader)
    throw ReadError(file,
                    fmt::format("it declares {} triangles, which are {} bytes, and has {} bytes",
                                declared_triangles(bytes),
                                kHeader + kFacet * declared_triangles(bytes), bytes.size()),
                    "it is cut off or damaged, or no STL file", "Write the mesh again");
  throw ReadError(file, "this is no STL file", "it neither begins with solid nor has a header",
                  "Write the mesh again");
}

} // namespace abbe
