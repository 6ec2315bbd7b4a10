#include "io/meshes/ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace abbe {
namespace {

struct WholeRange {
  std::int64_t lowest, highest;
};

WholeRange range_of(PlyType type) {
  const int bits = 8 * static_cast<int>(byte_count(type));
  const bool has_sign = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return has_sign ? WholeRange{-half, half - 1} : WholeRange{0, 2 * half - 1};
}

} // namespace

bool PlyTextValues::begin_row() {
  while (text_.line_is_done())
    if (!text_.next_line()) return false;
  return true;
}

void PlyTextValues::end_row() {
  if (text_.line_is_done()) return;
  const std::size_t at = place();
  throw error(at, fmt::format("{} is more than belongs here", text_.shown_word(at)),
              "the line holds more values than its element has");
}

double PlyTextValues::value(PlyType type) {
  if (type == PlyType::float64) return text_.number("a number");
  if (type == PlyType::float32) return text_.single_number("a number");
  const std::size_t at = place();
  const std::int64_t value = text_.whole_number("a whole number");
  if (const WholeRange range = range_of(type); value < range.lowest || value > range.highest)
    throw error(at, fmt::format("{} is out of range", text_.shown_word(at)),
                fmt::format("its type goes from {} to {}", range.lowest, range.highest));
  return static_cast<double>(value);
}

void PlyTextValues::skip(PlyType, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i)
    text_.number("a number");
}

ReadError PlyTextValues::error(std::size_t place, const std::string& what,
                               const std::string& why) const {
  return text_.error(place, what, why, "Write the mesh again");
}

/// A value takes a digit and, but for the last one, a separator.
bool PlyTextValues::can_hold(PlyType, std::uint64_t count) const {
  return count <= (text_.rest().size() + 1) / 2;
}

bool PlyTextValues::can_hold_rows(std::uint64_t rows, std::uint64_t values, std::uint64_t) const {
  return rows <= (text_.rest().size() + 1) / (2 * values);
}

void PlyTextValues::end_file() {
  if (!begin_row()) return;
  throw error(place(), "the file goes on after its last element", "the header declares no more");
}

/// The next value of the file. The caller has seen that it is there.
template <class Value>
Value PlyByteValues::take() {
  if (rest_.size() < sizeof(Value))
    throw error(place(), "the file ends within a value", "it is cut off");
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), rest_.data(), bytes.size());
  rest_.remove_prefix(bytes.size());
  if (big_endian_ != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
  return std::bit_cast<Value>(bytes);
}

double PlyByteValues::value(PlyType type) {
  switch (type) {
  case PlyType::int8:
    return take<std::int8_t>();
  case PlyType::uint8:
    return take<std::uint8_t>();
  case PlyType::int16:
    return take<std::int16_t>();
  case PlyType::uint16:
    return take<std::uint16_t>();
  case PlyType::int32:
    return take<std::int32_t>();
  case PlyType::uint32:
    return take<std::uint32_t>();
  case PlyType::float32:
    return take<float>();
  case PlyType::float64:
    return take<double>();
  }
  return 0.0;
}

void PlyByteValues::skip(PlyType type, std::uint64_t count) {
  if (!can_hold(type, count)) throw error(place(), "the file ends within a row", "it is cut off");
  rest_.remove_prefix(byte_count(type) * count);
}

ReadError PlyByteValues::error(std::size_t place, const std::string& what,
                               const std::string& why) const {
  return {file_, fmt::format("at byte {}, {}", place, what), why, "Write the mesh again"};
}

void PlyByteValues::end_file() const {
  if (rest_.find_first_not_of("\r\n") == std::string_view::npos) return;
  throw error(place(),
              fmt::format("the file goes on for {} bytes after its last element", rest_.size()),
              "the header declares no more");
}

} // namespace abbe
