#pragma once

#include "io/meshes/ply_header.h"

#include <string>
#include <string_view>

namespace abbe {

/// The values of a PLY file in text: a line for each row.
class PlyTextValues {
public:
  explicit PlyTextValues(MeshText& text) : text_(text) {}

  /// Goes to the next row. Returns false at the end of the file.
  bool begin_row();
  /// Throws unless the row ends here.
  void end_row();
  /// The next value. Those of a type of single precision are rounded to it, as they are in a file
  /// of bytes.
  double value(PlyType type);
  void skip(PlyType type, std::uint64_t count);
  /// Where the next value stands, for `error`.
  [[nodiscard]] std::size_t place() { return text_.offset(); }
  [[nodiscard]] ReadError error(std::size_t place, const std::string& what,
                                const std::string& why) const;
  /// False when the rest of the file surely cannot hold so many values.
  [[nodiscard]] bool can_hold(PlyType type, std::uint64_t count) const;
  /// The same for rows, of which each has so many values and bytes or more.
  [[nodiscard]] bool can_hold_rows(std::uint64_t rows, std::uint64_t values,
                                   std::uint64_t bytes) const;
  /// Throws unless nothing follows.
  void end_file();

private:
  MeshText& text_;
};

/// The values of a PLY file in bytes.
class PlyByteValues {
public:
  /// `content` follows the header, which has `offset` bytes.
  PlyByteValues(std::string_view content, std::size_t offset, bool big_endian,
                std::filesystem::path file)
      : rest_(content), file_size_(offset + content.size()), big_endian_(big_endian),
        file_(std::move(file)) {}

  [[nodiscard]] bool begin_row() const { return true; }
  void end_row() const {}
  double value(PlyType type);
  void skip(PlyType type, std::uint64_t count);
  [[nodiscard]] std::size_t place() const { return file_size_ - rest_.size(); }
  [[nodiscard]] ReadError error(std::size_t place, const std::string& what,
                                const std::string& why) const;
  [[nodiscard]] bool can_hold(PlyType type, std::uint64_t count) const {
    return count <= rest_.size() / byte_count(type);
  }
  [[nodiscard]] bool can_hold_rows(std::uint64_t rows, std::uint64_t, std::uint64_t bytes) const {
    return rows <= rest_.size() / bytes;
  }
  void end_file() const;

private:
  template <class Value>
  Value take();

  std::string_view rest_;
  std::size_t file_size_;
  bool big_endian_;
  std::filesystem::path file_;
};

} // namespace abbe
