#include "io/meshes/ply_header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace abbe {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

constexpr std::array<std::pair<std::string_view, PlyFormat>, 3> kFormats{{
    {"ascii", PlyFormat::text},
    {"binary_little_endian", PlyFormat::little_endian},
    {"binary_big_endian", PlyFormat::big_endian},
}};

/// What a word of a table means. `meaning` completes "... is no ...".
template <class Table>
auto choice(MeshText& text, const Table& table, std::string_view meaning) {
  const std::size_t place = text.offset();
  const std::string_view word = text.word();
  std::string right;
  for (const auto& [name, value] : table) {
    if (name == word) return value;
    right += fmt::format("{}{}", right.empty() ? "" : ", ", name);
  }
  throw text.error(place, fmt::format("{} is no {} of PLY", text.shown_word(place), meaning),
                   fmt::format("these are: {}", right), "Write the mesh again");
}

std::string name(MeshText& text) {
  const std::size_t place = text.offset();
  const std::string_view word = text.word();
  if (word.empty())
    throw text.error(place, "the line ends where a name should stand", "something is missing",
                     "Write the mesh again");
  return std::string(word);
}

void require_line_end(MeshText& text) {
  const std::size_t place = text.offset();
  if (!text.line_is_done())
    throw text.error(place, fmt::format("{} is more than belongs here", text.shown_word(place)),
                     "the line should have ended before", "Write the mesh again");
}

PlyFormat read_format(MeshText& text) {
  const PlyFormat format = choice(text, kFormats, "format");
  const std::size_t place = text.offset();
  if (text.word() != "1.0")
    throw text.error(place, fmt::format("{} is no version of PLY", text.shown_word(place)),
                     "there is 1.0 only", "Write the mesh again");
  return format;
}

PlyElement read_element(MeshText& text) {
  PlyElement element{name(text), 0, {}};
  const std::size_t place = text.offset();
  const std::int64_t count = text.whole_number("how many elements there are");
  if (count < 0)
    throw text.error(place, fmt::format("{} is no number of elements", text.shown_word(place)),
                     "it is below 0", "Write the mesh again");
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty read_property(MeshText& text) {
  PlyProperty property;
  MeshText ahead = text;
  if (ahead.word() == "list") {
    text.word();
    const std::size_t length_place = text.offset();
    property.length = choice(text, kTypes, "type");
    if (*property.length == PlyType::float32 || *property.length == PlyType::float64)
      throw text.error(length_place,
                       fmt::format("{} is no type of a length", text.shown_word(length_place)),
                       "a list has a whole number of values", "Write the mesh again");
  }
  property.type = choice(text, kTypes, "type");
  property.name = name(text);
  return property;
}

/// Goes past the line end. One of "\r" alone is known from the first line: after it a byte of the
/// content may look like the other half of "\r\n".
void skip_last_line_end(MeshText& text, bool pairs) {
  if (!text.line_is_done()) return;
  if (text.take('\r') && !pairs) return;
  text.take('\n');
}

} // namespace

std::size_t byte_count(PlyType type) {
  switch (type) {
  case PlyType::int8:
  case PlyType::uint8:
    return 1;
  case PlyType::int16:
  case PlyType::uint16:
    return 2;
  case PlyType::int32:
  case PlyType::uint32:
  case PlyType::float32:
    return 4;
  case PlyType::float64:
    return 8;
  }
  return 0;
}

PlyHeader read_ply_header(MeshText& text) {
  const auto fail = [&](std::size_t place, const std::string& what, const std::string& why) {
    return text.error(place, what, why, "Write the mesh again");
  };
  if (text.word() != "ply" || !text.line_is_done())
    throw fail(0, "this is no PLY file", "it does not begin with a line \"ply\"");
  const bool pairs = text.rest().starts_with("\r\n");
  PlyHeader header;
  bool has_format = false;
  while (text.next_line()) {
    const std::size_t place = text.offset();
    const std::string_view keyword = text.word();
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
    if (keyword == "end_header") {
      if (!has_format) throw fail(place, "the header names no format", "a line is missing");
      skip_last_line_end(text, pairs);
      return header;
    }
    if (keyword == "format") {
      header.format = read_format(text);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(text));
    } else if (keyword == "property") {
      if (header.elements.empty())
        throw fail(place, "a property stands before the first element", "it belongs to none");
      header.elements.back().properties.push_back(read_property(text));
    } else {
      throw fail(place, fmt::format("{} is no keyword of a header", text.shown_word(place)),
                 "these are: format, element, property, comment, obj_info, end_header");
    }
    require_line_end(text);
  }
  throw fail(text.offset(), "the file ends within its header", "there is no \"end_header\"");
}

} // namespace abbe
