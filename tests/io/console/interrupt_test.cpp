#include "io/console/interrupt.h"

#include "tests/catch.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

using namespace abbe;

namespace {

/// How a process of its own ends that does this: its exit code, or minus the signal.
int end_of(const std::function<int()>& action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(action());
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return 1000;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace

TEST_CASE("each signal that asks for an end is noted, and twice at once is once") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
    CAPTURE(signal);
    CHECK(end_of([signal] {
            const std::atomic<bool>& stop = interrupted();
            if (stop) return 1;
            std::raise(signal);
            std::raise(signal);
            return stop ? 0 : 2;
          }) == 0);
  }
}

TEST_CASE("a signal a second later ends the program at once") {
  CHECK(end_of([] {
          (void)interrupted();
          std::raise(SIGTERM);
          ::usleep(1'100'000);
          std::raise(SIGINT);
          return 0;
        }) == -SIGINT);
}

TEST_CASE("a signal that the caller ignores stays ignored") {
  CHECK(end_of([] {
          std::signal(SIGHUP, SIG_IGN);
          const std::atomic<bool>& stop = interrupted();
          std::raise(SIGHUP);
          return stop ? 1 : 0;
        }) == 0);
}
