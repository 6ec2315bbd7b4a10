#include "io/console/interrupt.h"

#include "io/files/temporary_names.h"

#include <csignal>
#include <ctime>

namespace abbe {
namespace {

std::atomic<bool> flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not lock");

/// When the first signal came, on a clock that is never set.
volatile std::time_t first_second = 0;
volatile long first_nanosecond = 0;

/// True when the first signal came less than a second ago.
bool just_asked() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const std::time_t seconds = now.tv_sec - first_second;
  return seconds < 1 || (seconds == 1 && now.tv_nsec < first_nanosecond);
}

/// Calls what signal handlers may call, and nothing else.
extern "C" void on_signal(int signal) {
  if (!flag.exchange(true)) {
    std::timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    first_second = now.tv_sec;
    first_nanosecond = now.tv_nsec;
    return;
  }
  if (just_asked()) return;
  remove_temporary_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

} // namespace

const std::atomic<bool>& interrupted() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU})
    // What the caller ignores stays ignored: nohup asks for that.
    if (std::signal(signal, on_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  return flag;
}

} // namespace abbe
