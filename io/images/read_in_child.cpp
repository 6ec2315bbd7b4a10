#include "io/images/read_in_child.h"

#include "io/files/available_memory.h"
#include "io/files/throw_errno.h"
#include "io/images/read_image.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace abbe {
namespace {

/// What a child sends before its text, which is that of an error where it failed, and its values.
struct Announcement {
  bool failed = false;
  std::size_t text_size = 0, value_count = 0;
};

/// Sends all bytes; the child ends where nobody reads them.
void send(int pipe, const void* from, std::size_t count) {
  const auto* bytes = static_cast<const char*>(from);
  while (count > 0) {
    const ssize_t sent = ::write(pipe, bytes, count);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) ::_exit(EXIT_FAILURE);
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

void send_message(int pipe, const ChildMessage& message) {
  const Announcement announcement{false, message.text.size(), message.values.size()};
  send(pipe, &announcement, sizeof announcement);
  send(pipe, message.text.data(), message.text.size());
  send(pipe, message.values.data(), message.values.size() * sizeof(float));
}

void send_error(int pipe, std::string_view text) {
  const Announcement announcement{true, text.size(), 0};
  send(pipe, &announcement, sizeof announcement);
  send(pipe, text.data(), text.size());
}

void limit(int resource, std::uint64_t most) {
  rlimit limits{};
  if (::getrlimit(resource, &limits) != 0) return;
  limits.rlim_cur = std::min<rlim_t>(limits.rlim_max, most);
  (void)::setrlimit(resource, &limits);
}

/// What the child does. It ends without the destructors and buffers that it has in common with the
/// program.
[[noreturn]] void read_and_send(int pipe, const std::function<ChildMessage()>& read,
                                const ReadingLimits& limits) {
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGXCPU, SIGALRM, SIGABRT, SIGSEGV, SIGBUS, SIGFPE})
    std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(limits.processor_seconds));
  limit(RLIMIT_AS, address_space() + limits.memory);
  ::alarm(static_cast<unsigned>(limits.seconds));
  try {
    send_message(pipe, read());
  } catch (const std::bad_alloc&) {
    send_error(pipe,
               fmt::format("reading it takes more than {} of memory", memory_text(limits.memory)));
  } catch (const std::exception& error) {
    send_error(pipe, error.what());
  }
  ::_exit(EXIT_SUCCESS);
}

/// The process and the pipe from it, until the end of the scope.
class Child {
public:
  Child(const std::function<ChildMessage()>& read, const ReadingLimits& limits) : limits_(limits) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno();
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      read_and_send(ends[1], read, limits);
    }
    ::close(ends[1]);
    pipe_ = ends[0];
    if (process_ < 0) {
      ::close(pipe_);
      throw_errno();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    ::close(pipe_);
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      (void)wait();
    }
  }

  /// Throws where the child ends before.
  template <class Value>
  void receive(std::span<Value> values) {
    const std::span<std::byte> bytes = std::as_writable_bytes(values);
    for (std::size_t filled = 0; filled < bytes.size();) {
      const ssize_t count = ::read(pipe_, bytes.data() + filled, bytes.size() - filled);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw_errno();
      if (count == 0) throw std::runtime_error(end_of(wait()));
      filled += static_cast<std::size_t>(count);
    }
  }

private:
  int wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  [[nodiscard]] std::string end_of(int status) const {
    if (!WIFSIGNALED(status))
      return fmt::format("its reader ended with exit code {}", WEXITSTATUS(status));
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU)
      return fmt::format("reading it takes more than {} s", limits_.processor_seconds);
    if (signal == SIGALRM) return fmt::format("reading it takes more than {} s", limits_.seconds);
    return fmt::format("its reader ended by signal {} ({}), it is damaged", signal,
                       ::strsignal(signal));
  }

  ReadingLimits limits_;
  pid_t process_ = -1;
  int pipe_ = -1;
};

} // namespace

ChildMessage message_of_child(const std::function<ChildMessage()>& read,
                              const ReadingLimits& limits) {
  Child child(read, limits);
  Announcement announcement;
  child.receive(std::span(&announcement, 1));
  ChildMessage message;
  message.text.resize(announcement.text_size);
  child.receive(std::span(message.text));
  if (announcement.failed) throw std::runtime_error(message.text);
  require_image_memory(announcement.value_count, 1, sizeof(float));
  message.values.resize(announcement.value_count);
  child.receive(std::span(message.values));
  return message;
}

ExrImage read_in_child(const std::function<ExrImage()>& read, const ReadingLimits& limits) {
  ChildMessage message = message_of_child(
      [&] {
        ExrImage image = read();
        return ChildMessage{fmt::format("{} {} {}", image.width, image.height, image.unknown_tag),
                            std::move(image.rgb)};
      },
      limits);
  // The sizes stand before the tag, which may have spaces.
  const std::size_t second = message.text.find(' '), tag = message.text.find(' ', second + 1);
  return {std::stoi(message.text), std::stoi(message.text.substr(second)),
          std::move(message.values), message.text.substr(tag + 1)};
}

} // namespace abbe
