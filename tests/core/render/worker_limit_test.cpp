#include "core/render/worker_limit.h"

#include "tests/catch.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace abbe;

TEST_CASE("threads are counted that the system makes") {
  CHECK(threads_that_can_be_made(0) == 0);
  CHECK(threads_that_can_be_made(3) == 3);
  const Workers workers = limit_workers(3);
  CHECK(workers.wanted == 3);
  CHECK(workers.allowed == 3);
}

TEST_CASE("where the system refuses a thread, fewer work") {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    // Each thread's stack takes megabytes of address space, of which none is left.
    const rlimit none{1 << 20, 1 << 20};
    if (::setrlimit(RLIMIT_AS, &none) != 0) ::_exit(2);
    ::_exit(threads_that_can_be_made(64) < 64 ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
