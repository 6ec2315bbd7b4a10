#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace abbe {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_errno() {
  throw std::runtime_error(std::generic_category().message(errno));
}

/// The file to replace: the end of a chain of symbolic links, and never a device or a folder.
fs::path resolved_target(const fs::path& target) {
  std::error_code ignored;
  fs::path resolved = fs::is_symlink(target, ignored) ? fs::canonical(target) : target;
  if (resolved.filename().empty()) throw std::runtime_error("the name of the file is missing");
  if (fs::exists(resolved, ignored) && !fs::is_regular_file(resolved, ignored))
    throw std::runtime_error("not a regular file");
  return resolved;
}

/// An empty file beside the target, removed at the end of its scope unless it was renamed.
class TemporaryFile {
public:
  explicit TemporaryFile(const fs::path& target) {
    // O_EXCL and not the process id alone: two machines of a farm may share folder and id.
    for (int attempt = 0;; ++attempt) {
      path_ = target;
      path_.replace_filename(fmt::format("{}.tmp-{}-{}{}", target.stem().string(), ::getpid(),
                                         attempt, target.extension().string()));
      const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file >= 0) {
        ::close(file);
        return;
      }
      if (errno != EEXIST) throw_errno();
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    if (!renamed_) fs::remove(path_, ignored);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }

  void rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) throw_errno();
    renamed_ = true;
  }

private:
  fs::path path_;
  bool renamed_ = false;
};

/// Waits until the content is on the disk, so that after a power cut the name never leads to an
/// empty file; it also brings out a full disk that the file system had not reported yet.
void flush_to_disk(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw_errno();
  const int result = ::fsync(file);
  const int error = errno;
  ::close(file);
  errno = error;
  if (result != 0 && error != EINVAL) throw_errno(); // EINVAL: this file system cannot
}

} // namespace

void replace_file(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  try {
    const fs::path resolved = resolved_target(target);
    TemporaryFile temporary(resolved);
    write(temporary.path());
    flush_to_disk(temporary.path());
    temporary.rename_to(resolved);
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", target.string(), error.code().message()));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", target.string(), error.what()));
  }
}

} // namespace abbe
