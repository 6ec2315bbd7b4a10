#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace abbe {

/// A long array of integer sums, 0 at first, in memory or in a file.
///
/// The file has no name, so it is gone when the process ends, however it ends. All of its space is
/// taken on the disk at once: a full disk is told at the beginning, and not by a signal later.
class FileBackedSums {
public:
  /// No sums.
  FileBackedSums();
  /// In memory. Errors: std::bad_alloc.
  explicit FileBackedSums(std::size_t count);
  /// In a file in the folder, of which about `resident` bytes are in memory at once.
  /// Errors: std::runtime_error, which names the folder and the size.
  FileBackedSums(std::size_t count, const std::filesystem::path& folder,
                 std::size_t resident = kResidentBytes);
  FileBackedSums(FileBackedSums&&) noexcept;
  FileBackedSums& operator=(FileBackedSums&&) noexcept;
  ~FileBackedSums();

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::int64_t& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] std::int64_t operator[](std::size_t i) const { return data_[i]; }

  /// Tells that about so many sums, not told of before, were read or written. When those in a file
  /// fill what may be resident, the process gives back the memory that shows them; their values
  /// stay. Any number of threads may tell, read and write meanwhile.
  void touched(std::size_t count) const;

  static constexpr std::size_t kResidentBytes = std::size_t{256} << 20;

private:
  struct Mapping;
  std::unique_ptr<Mapping> mapping_;
  std::int64_t* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace abbe
