#include "io/files/regular_file.h"

#include "io/files/throw_errno.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace abbe {
namespace {

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "it is a folder";
  if (S_ISFIFO(mode)) return "it is a pipe";
  if (S_ISSOCK(mode)) return "it is a socket";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "it is a device";
  return "it is not a regular file";
}

/// A file that is open for reading, until the end of its scope.
class OpenFile {
public:
  explicit OpenFile(const std::filesystem::path& path)
      // Without O_NONBLOCK, opening a pipe waits until somebody writes into it.
      : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    struct stat status{};
    if (file_ < 0 && ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
      throw std::runtime_error(kind_of(status.st_mode)); // a socket cannot even be opened
    if (file_ < 0) throw_errno();
    try {
      if (::fstat(file_, &status) != 0) throw_errno();
      if (!S_ISREG(status.st_mode)) throw std::runtime_error(kind_of(status.st_mode));
    } catch (...) {
      ::close(file_);
      throw;
    }
    size_ = static_cast<std::size_t>(status.st_size);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { ::close(file_); }

  /// What the file system says; files that it makes up on the fly hold more than that.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Returns the number of bytes read, 0 at the end.
  [[nodiscard]] std::size_t read(char* bytes, std::size_t most) const {
    while (true) {
      const ssize_t count = ::read(file_, bytes, most);
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) throw_errno();
    }
  }

private:
  int file_ = -1;
  std::size_t size_ = 0;
};

} // namespace

void require_regular_file(const std::filesystem::path& path) {
  const OpenFile file(path);
}

std::string read_regular_file(const std::filesystem::path& path) {
  const OpenFile file(path);
  std::string content(file.size() + 1, '\0'); // the byte more finds the end without another round
  std::size_t filled = 0;
  while (const std::size_t count = file.read(content.data() + filled, content.size() - filled)) {
    filled += count;
    if (filled == content.size()) content.resize(2 * content.size() + 4096);
  }
  content.resize(filled);
  return content;
}

} // namespace abbe
