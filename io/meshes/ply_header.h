#pragma once

#include "io/meshes/mesh_text.h"

#include <optional>
#include <string>
#include <vector>

namespace abbe {

enum class PlyFormat { text, little_endian, big_endian };

/// The types of numbers in a PLY file.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t byte_count(PlyType type);

/// One value, or a list that begins with its length.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> length; ///< the type of a list's length
};

/// Rows that have the same properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
};

/// Reads the header and leaves the text at the first byte after it. Throws ReadError at the word.
[[nodiscard]] PlyHeader read_ply_header(MeshText& text);

} // namespace abbe
