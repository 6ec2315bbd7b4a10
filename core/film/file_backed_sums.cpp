#include "core/film/file_backed_sums.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace abbe {
namespace {

class FileDescriptor {
public:
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

private:
  int number_;
};

[[noreturn]] void fail(const std::filesystem::path& folder, std::size_t bytes, int error) {
  throw std::runtime_error(fmt::format(
      "{}: there is no room for a temporary file of {:.2f} GiB, for sums of pixels: {}. Give "
      "the variable TMPDIR a folder on a disk with room, or take fewer bands, layers or pixels",
      folder.string(), static_cast<double>(bytes) * 0x1p-30,
      std::generic_category().message(error)));
}

/// A new file without a name.
int open_unnamed(const std::filesystem::path& folder, std::size_t bytes) {
  // O_TMPFILE would do it in one step, but not every file system has it.
  std::string name = (folder / "abbe-bands-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) fail(folder, bytes, errno);
  ::unlink(name.c_str());
  return file;
}

} // namespace

struct FileBackedSums::Mapping {
  void* start;
  std::size_t bytes;
  bool in_file;
  std::size_t resident;                 ///< bytes that may be in memory, of a file
  std::atomic<std::size_t> touched = 0; ///< bytes since memory was given back

  /// `file` is -1 for memory.
  Mapping(std::size_t size, int file, std::size_t most_resident)
      : start(::mmap(nullptr, size, PROT_READ | PROT_WRITE,
                     file < 0 ? MAP_PRIVATE | MAP_ANONYMOUS : MAP_SHARED, file, 0)),
        bytes(size), in_file(file >= 0), resident(most_resident) {
    if (start == MAP_FAILED) throw std::bad_alloc();
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping() { ::munmap(start, bytes); }
};

FileBackedSums::FileBackedSums() = default;
FileBackedSums::~FileBackedSums() = default;

FileBackedSums::FileBackedSums(FileBackedSums&& other) noexcept
    : mapping_(std::move(other.mapping_)), data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)) {}

FileBackedSums& FileBackedSums::operator=(FileBackedSums&& other) noexcept {
  mapping_ = std::move(other.mapping_);
  data_ = std::exchange(other.data_, nullptr);
  size_ = std::exchange(other.size_, 0);
  return *this;
}

FileBackedSums::FileBackedSums(std::size_t count) {
  if (count == 0) return;
  mapping_ = std::make_unique<Mapping>(count * sizeof(std::int64_t), -1, 0);
  data_ = static_cast<std::int64_t*>(mapping_->start);
  size_ = count;
}

FileBackedSums::FileBackedSums(std::size_t count, const std::filesystem::path& folder,
                               std::size_t resident) {
  if (count == 0) return;
  const std::size_t bytes = count * sizeof(std::int64_t);
  const FileDescriptor file(open_unnamed(folder, bytes));
  if (const int error = ::posix_fallocate(file.number(), 0, static_cast<off_t>(bytes)); error != 0)
    fail(folder, bytes, error);
  mapping_ = std::make_unique<Mapping>(bytes, file.number(), resident);
  data_ = static_cast<std::int64_t*>(mapping_->start);
  size_ = count;
}

void FileBackedSums::touched(std::size_t count) const {
  if (!mapping_ || !mapping_->in_file) return;
  const std::size_t bytes = count * sizeof(std::int64_t);
  if (mapping_->touched.fetch_add(bytes, std::memory_order_relaxed) + bytes < mapping_->resident)
    return;
  mapping_->touched.store(0, std::memory_order_relaxed);
  // Of a shared file this unmaps pages and loses nothing: the next access finds them in the file.
  ::madvise(mapping_->start, mapping_->bytes, MADV_DONTNEED);
}

} // namespace abbe
