#include "io/files/atomic_file.h"

#include "io/files/temporary_names.h"
#include "io/files/throw_errno.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// A file that is to be replaced, or made.
struct Target {
  fs::path path;                  ///< the end of a chain of symbolic links
  std::optional<struct stat> old; ///< of the file that is there
};

/// Throws for what is no regular file and for a file that nobody may write to.
Target find_target(const fs::path& name) {
  if (name.filename().empty()) throw std::runtime_error("the name of the file is missing");
  struct stat status{};
  if (::lstat(name.c_str(), &status) != 0) {
    if (errno == ENOENT) return {name, std::nullopt};
    throw_errno();
  }
  Target target{name, std::nullopt};
  if (S_ISLNK(status.st_mode)) {
    if (::stat(name.c_str(), &status) != 0) {
      if (errno == ENOENT) throw std::runtime_error("it is a link that leads nowhere");
      throw_errno(); // links that lead in a circle
    }
    target.path = fs::canonical(name);
  }
  if (S_ISDIR(status.st_mode)) throw std::runtime_error("this is a folder");
  if (!S_ISREG(status.st_mode)) throw std::runtime_error("not a regular file");
  // The bits count, not what this process may do: the administrator may write to everything.
  constexpr mode_t kAnyWriter = S_IWUSR | S_IWGRP | S_IWOTH;
  if ((status.st_mode & kAnyWriter) == 0 || ::access(target.path.c_str(), W_OK) != 0)
    throw std::runtime_error("the file is read-only");
  target.old = status;
  return target;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void write_all(int to, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(to, bytes, count);
    if (written < 0 && errno != EINTR) throw_errno();
    if (written < 0) continue;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

/// What the names of this machine's temporary files begin with. Machines of a farm share folders.
std::string temporary_prefix() {
  std::array<char, 65> host{}; // Linux allows 64 characters
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  return fmt::format(".abbe-{}-", host.data());
}

/// Takes the lock that tells that a temporary file is in use; it is free again when the file is
/// closed, which also the end of the process does. Returns false where another holds it, and where
/// the file system has no locks, so that nothing is removed there.
bool lock_if_free(int file) {
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

/// Removes what processes have left in the folder that were killed while they wrote.
void remove_abandoned(const fs::path& folder) {
  const std::string prefix = temporary_prefix();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(".tmp")) continue;
    const int file =
        ::open(entry->path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
    if (file < 0) continue;
    if (lock_if_free(file)) ::unlink(entry->path().c_str());
    ::close(file);
  }
}

/// An empty file in the folder of the target, gone at the end of its scope unless it took its name.
class TemporaryFile {
public:
  explicit TemporaryFile(const Target& target) : target_(target) {
    const fs::path folder = folder_of(target.path);
    remove_abandoned(folder);
    file_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    // Not all file systems have unnamed files, and without /proc they cannot be named later.
    if (file_ >= 0 && ::access(open_path().c_str(), W_OK) != 0) ::close(std::exchange(file_, -1));
    if (file_ < 0)
      open_named();
    else
      (void)lock_if_free(file_); // before it has a name
    if (target.old) (void)::fchmod(file_, target.old->st_mode & 07777U);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!name_.empty()) ::unlink(name_.c_str());
    ::close(file_);
  }

  /// The name under which it can be opened.
  [[nodiscard]] fs::path path() const { return name_.empty() ? open_path() : name_; }

  /// Waits until the content is on the disk, so that after a power cut the name never leads to an
  /// empty file; it also brings out a full disk that the file system had not reported yet.
  void flush_to_disk() const {
    if (::fsync(file_) != 0 && errno != EINVAL) throw_errno(); // EINVAL: this file system cannot
  }

  void take_name() {
    if (target_.old && target_.old->st_nlink > 1) return fill_target();
    if (name_.empty()) link();
    if (::rename(name_.c_str(), target_.path.c_str()) != 0) throw_errno();
    removed_by_signals_.reset();
    name_.clear();
  }

private:
  [[nodiscard]] fs::path open_path() const { return fmt::format("/proc/self/fd/{}", file_); }

  /// A name of a length of its own: the target's may be as long as names can be.
  [[nodiscard]] fs::path name(int attempt) const {
    return folder_of(target_.path) /
           fmt::format("{}{}-{}.tmp", temporary_prefix(), ::getpid(), attempt);
  }

  void set_name(const fs::path& path) {
    removed_by_signals_.emplace(path);
    name_ = path;
  }

  void open_named() {
    // O_EXCL and not the process id alone: two machines of a farm may share folder and id.
    for (int attempt = 0; file_ < 0; ++attempt) {
      const fs::path path = name(attempt);
      file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ < 0 && errno != EEXIST) throw_errno();
      if (file_ >= 0 && !keep_named(path)) ::close(std::exchange(file_, -1));
    }
  }

  /// Locks the file that has just been made. Returns false where another process has taken it for
  /// an abandoned one before, and has removed it.
  bool keep_named(const fs::path& path) {
    struct stat status{};
    if (!lock_if_free(file_) && errno == EWOULDBLOCK) return false;
    if (::fstat(file_, &status) == 0 && status.st_nlink == 0) return false;
    set_name(path);
    return true;
  }

  /// Gives an unnamed file a name. No call lets it replace another file at once.
  void link() {
    for (int attempt = 0;; ++attempt) {
      const fs::path path = name(attempt);
      if (::linkat(AT_FDCWD, open_path().c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0)
        return set_name(path);
      if (errno != EEXIST) throw_errno();
    }
  }

  /// Copies the content into the file that is there.
  void fill_target() const {
    const int to = ::open(target_.path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (to < 0) throw_errno();
    try {
      std::array<char, 1 << 16> bytes;
      off_t offset = 0;
      while (const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), offset)) {
        if (count < 0) throw_errno();
        write_all(to, bytes.data(), static_cast<std::size_t>(count));
        offset += count;
      }
      if (::fsync(to) != 0 && errno != EINVAL) throw_errno();
    } catch (...) {
      ::close(to);
      throw;
    }
    if (::close(to) != 0) throw_errno();
  }

  Target target_;
  fs::path name_; ///< empty for an unnamed file
  std::optional<TemporaryName> removed_by_signals_;
  int file_ = -1;
};

/// While it lives, a file that grows beyond the limit of its size is an error of writing and does
/// not end the program.
class IgnoreSizeSignal {
public:
  IgnoreSizeSignal() : before_(std::signal(SIGXFSZ, SIG_IGN)) {}
  IgnoreSizeSignal(const IgnoreSizeSignal&) = delete;
  IgnoreSizeSignal& operator=(const IgnoreSizeSignal&) = delete;
  ~IgnoreSizeSignal() { std::signal(SIGXFSZ, before_); }

private:
  void (*before_)(int);
};

/// Does something for a target and gives all that it throws the target's name.
template <class Action>
void with_name(const fs::path& target, const Action& action) {
  try {
    action();
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", target.string(), error.code().message()));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("cannot write {}: {}", target.string(), error.what()));
  }
}

} // namespace

void replace_file(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  with_name(target, [&] {
    const IgnoreSizeSignal ignore;
    TemporaryFile temporary(find_target(target));
    write(temporary.path());
    temporary.flush_to_disk();
    temporary.take_name();
  });
}

void require_replaceable(const fs::path& name) {
  with_name(name, [&] {
    const Target target = find_target(name);
    const fs::path folder = folder_of(target.path);
    if (!fs::is_directory(folder))
      throw std::runtime_error(fmt::format("there is no folder {}", folder.string()));
    if (::access(folder.c_str(), W_OK) != 0)
      throw std::runtime_error(fmt::format("the folder {} cannot be written to", folder.string()));
  });
}

} // namespace abbe
