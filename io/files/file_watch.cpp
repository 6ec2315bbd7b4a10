#include "io/files/file_watch.h"

#include "io/files/throw_errno.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace abbe {

namespace fs = std::filesystem;

FileWatch::FileWatch() : queue_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (queue_ < 0) throw_errno();
}

FileWatch::~FileWatch() {
  ::close(queue_);
}

void FileWatch::follow(const std::vector<fs::path>& files) {
  std::map<int, std::set<std::string>> names;
  for (const fs::path& file : files) {
    // Folders are watched, since a file that is replaced by another is no longer the one watched.
    // Where a name is a link, what it leads to may be saved as well.
    std::error_code error;
    for (const fs::path& place : {fs::absolute(file), fs::weakly_canonical(file, error)}) {
      if (place.empty()) continue;
      const int watch =
          ::inotify_add_watch(queue_, place.parent_path().c_str(), IN_CLOSE_WRITE | IN_MOVED_TO);
      if (watch < 0 && errno == ENOENT) continue; // a folder that is not there
      if (watch < 0) throw_errno();
      names[watch].insert(place.filename().string());
    }
  }
  const std::lock_guard lock(mutex_);
  for (const auto& [watch, old] : names_)
    if (!names.contains(watch)) ::inotify_rm_watch(queue_, watch);
  names_ = std::move(names);
}

bool FileWatch::wait(double seconds) {
  pollfd wanted{queue_, POLLIN, 0};
  if (::poll(&wanted, 1, static_cast<int>(seconds * 1e3)) <= 0) return false;
  const std::lock_guard lock(mutex_);
  bool saved = false;
  alignas(inotify_event) std::array<char, 16384> bytes{};
  for (ssize_t size; (size = ::read(queue_, bytes.data(), bytes.size())) > 0;)
    for (std::size_t at = 0; at < static_cast<std::size_t>(size);) {
      inotify_event event{};
      std::memcpy(&event, bytes.data() + at, sizeof event);
      const char* const name = bytes.data() + at + sizeof event;
      const auto folder = names_.find(event.wd);
      // Where the queue was too short, anything may have been saved.
      saved = saved || (event.mask & IN_Q_OVERFLOW) != 0 ||
              (event.len > 0 && folder != names_.end() && folder->second.contains(name));
      at += sizeof event + event.len;
    }
  return saved;
}

} // namespace abbe
