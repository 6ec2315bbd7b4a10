#include "io/files/temporary_names.h"

#include "io/console/interrupt.h"
#include "io/files/atomic_file.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <optional>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;
using test::put;

namespace {

/// From now on this process has no unnamed files, as on file systems without them. False where the
/// system does not allow that.
bool forbid_unnamed_files() {
  constexpr unsigned kUnnamed = O_TMPFILE & ~static_cast<unsigned>(O_DIRECTORY);
  std::array<sock_filter, 6> filter{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, kUnnamed, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  }};
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

constexpr int kNotAllowed = 77, kNoName = 78;

} // namespace

TEST_CASE("a signal handler removes the files whose names are kept, and no others") {
  const Folder folder;
  const fs::path kept = folder.path / "kept", given_back = folder.path / "given back";
  put(kept, "x");
  put(given_back, "x");
  std::optional<TemporaryName> past(given_back);
  const TemporaryName name(kept);
  past.reset();
  remove_temporary_files();
  CHECK_FALSE(fs::exists(kept));
  CHECK(fs::exists(given_back));
}

TEST_CASE("more names than can be kept are no error") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  put(file, "x");
  std::array<std::optional<TemporaryName>, 20> names;
  for (auto& name : names)
    name.emplace(folder.path / "none");
  const TemporaryName last(file);
  remove_temporary_files();
  CHECK(fs::exists(file));
}

TEST_CASE("a second signal during writing leaves no temporary file where all files have names") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    if (!forbid_unnamed_files()) ::_exit(kNotAllowed);
    (void)interrupted();
    replace_file(target, [&](const fs::path& temporary) {
      put(temporary, "half of the new");
      if (temporary.parent_path() != folder.path) ::_exit(kNoName);
      std::raise(SIGINT);
      ::usleep(1'100'000);
      std::raise(SIGINT);
    });
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotAllowed) return; // it cannot be tried here
  REQUIRE(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGINT);
  CHECK(content(target) == "old");
  CHECK(folder.file_count() == 1);
}
