#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace abbe {

// Files of states: a signature, a version, and blocks, each with its checksum.
// docs/state_format.md describes them.

inline constexpr std::uint32_t kStateVersion = 1;

/// Writes blocks one after the other into a file that it makes anew. Errors: std::runtime_error
/// with the system's reason.
class BlockWriter {
public:
  explicit BlockWriter(const std::filesystem::path& file);
  /// The name has four characters.
  void write(std::string_view name, std::string_view content);
  /// Writes the last block, and all that is not in the file yet.
  void end();

private:
  void put(std::string_view bytes);
  std::ofstream file_;
  std::uint64_t blocks_ = 0;
};

/// Reads them back, one block at a time. Errors: ReadError, for a file that is none of these, of
/// another version, or not what was written.
class BlockReader {
public:
  explicit BlockReader(const std::filesystem::path& file);
  /// The content of the next block, which must have this name.
  [[nodiscard]] const std::string& read(std::string_view name);
  /// Reads the last block; nothing may come after it.
  void end();
  /// Throws the error for a block whose content is not what it should be.
  [[noreturn]] void refuse(const std::string& reason) const;

private:
  /// Reads so many bytes into the string, whose memory is used again.
  void take(std::uint64_t size, std::string& bytes);
  [[nodiscard]] std::string take(std::uint64_t size);
  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t size_ = 0, position_ = 0, blocks_ = 0;
  std::string name_, content_;
};

/// True for a file that begins as the files of states do.
[[nodiscard]] bool is_state_file(const std::filesystem::path& file);

} // namespace abbe
