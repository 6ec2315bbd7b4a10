#include "io/files/atomic_file.h"

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;
using test::put;

namespace {

template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("replace_file writes beside the target and renames") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  replace_file(target, [&](const fs::path& temporary) {
    CHECK(temporary != target);
    CHECK(content(target) == "old");
    put(temporary, "new");
    CHECK(content(target) == "old");
  });
  CHECK(content(target) == "new");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("two writers of one target have different temporaries") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  replace_file(target, [&](const fs::path& outer) {
    put(outer, "outer");
    replace_file(target, [&](const fs::path& inner) {
      CHECK(inner != outer);
      put(inner, "inner");
    });
    CHECK(content(target) == "inner");
    CHECK(content(outer) == "outer");
  });
  CHECK(content(target) == "outer");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("what killed processes of this machine have left is removed, and nothing else") {
  const Folder folder;
  std::string host(65, '\0');
  REQUIRE(::gethostname(host.data(), host.size()) == 0);
  host.resize(host.find('\0'));
  const fs::path abandoned = folder.path / (".abbe-" + host + "-1-0.tmp");
  const fs::path in_use = folder.path / (".abbe-" + host + "-2-0.tmp");
  const fs::path of_another = folder.path / (".abbe-" + host + "2-1-0.tmp");
  const fs::path of_the_user = folder.path / "abbe-notes.tmp";
  for (const fs::path& path : {abandoned, in_use, of_another, of_the_user})
    put(path, "some bytes");
  const int file = ::open(in_use.c_str(), O_RDONLY);
  REQUIRE(::flock(file, LOCK_EX) == 0); // as a process that is writing it does

  const auto write = [&](const fs::path& temporary) { put(temporary, "new"); };
  replace_file(folder.path / "picture.exr", write);
  CHECK_FALSE(fs::exists(abandoned));
  CHECK(content(in_use) == "some bytes");
  CHECK(content(of_another) == "some bytes");
  CHECK(content(of_the_user) == "some bytes");
  ::close(file);
  replace_file(folder.path / "picture.exr", write);
  CHECK_FALSE(fs::exists(in_use));
  CHECK(folder.file_count() == 3);
}

TEST_CASE("a failed write keeps the old file, removes the temporary and says why") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  const std::string message = message_of([&] {
    replace_file(target, [](const fs::path& temporary) {
      put(temporary, "half of the new");
      throw std::runtime_error("the disk is full");
    });
  });
  CHECK(message == "cannot write " + target.string() + ": the disk is full");
  CHECK(content(target) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a target that cannot be written is refused before anything is written") {
  const Folder folder;
  const auto write = [](const fs::path&) { FAIL("must not be called"); };
  const fs::path lost = folder.path / "no_folder" / "picture.exr";
  CHECK(message_of([&] { replace_file(lost, write); }) ==
        "cannot write " + lost.string() + ": No such file or directory");
  CHECK(message_of([&] { replace_file(folder.path, write); }) ==
        "cannot write " + folder.path.string() + ": this is a folder");
  CHECK(message_of([&] { replace_file("/dev/null", write); }) ==
        "cannot write /dev/null: not a regular file");
  CHECK(message_of([&] { replace_file("", write); }) ==
        "cannot write : the name of the file is missing");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a name as long as names can be is written") {
  const Folder folder;
  const fs::path target = folder.path / (std::string(251, 'a') + ".exr");
  require_replaceable(target);
  replace_file(target, [](const fs::path& temporary) { put(temporary, "new"); });
  CHECK(content(target) == "new");
  const fs::path longer = folder.path / (std::string(252, 'a') + ".exr");
  CHECK(message_of([&] { require_replaceable(longer); }) ==
        "cannot write " + longer.string() + ": File name too long");
}

TEST_CASE("what cannot be replaced is known before the work") {
  const Folder folder;
  put(folder.path / "old", "old");
  fs::permissions(folder.path / "old", fs::perms::owner_read);
  fs::create_symlink("none", folder.path / "dangling");
  fs::create_symlink("loop", folder.path / "loop");
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  const auto check = [&](const fs::path& target, const std::string& why) {
    const std::string message = "cannot write " + target.string() + ": " + why;
    CHECK(message_of([&] { require_replaceable(target); }) == message);
    if (why.find("folder") == std::string::npos)
      CHECK(message_of([&] { replace_file(target, [](const fs::path&) { FAIL("called"); }); }) ==
            message);
  };
  check(folder.path / "old", "the file is read-only");
  check(folder.path / "dangling", "it is a link that leads nowhere");
  check(folder.path / "loop", "Too many levels of symbolic links");
  check(folder.path / "pipe", "not a regular file");
  check("/dev/null", "not a regular file");
  check(folder.path, "this is a folder");
  check(folder.path / "no" / "x.exr", "there is no folder " + (folder.path / "no").string());
  CHECK(content(folder.path / "old") == "old");
  CHECK(folder.file_count() == 4);
}

TEST_CASE("a file keeps its permissions, and all its names") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr", other = folder.path / "other.exr";
  put(target, "old and longer");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  replace_file(target, [](const fs::path& temporary) { put(temporary, "new"); });
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  fs::create_hard_link(target, other);
  replace_file(target, [](const fs::path& temporary) { put(temporary, "newest"); });
  CHECK(content(other) == "newest");
  CHECK(fs::hard_link_count(target) == 2);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a process that is killed while it writes leaves nothing") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    replace_file(target, [](const fs::path& temporary) {
      put(temporary, "half of the new");
      ::kill(::getpid(), SIGKILL);
    });
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(WIFSIGNALED(status));
  CHECK(content(target) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a file beyond the limit of its size is an error, not the end") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{1000, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const std::string message = message_of([&] {
    replace_file(target, [](const fs::path& temporary) {
      std::ofstream file(temporary);
      file << std::string(5000, 'x') << std::flush;
      if (!file) throw std::runtime_error("the file is too large");
    });
  });
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
  CHECK(message == "cannot write " + target.string() + ": the file is too large");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a symbolic link stays a link; what it points to is replaced") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr", link = folder.path / "link.exr";
  put(target, "old");
  fs::create_symlink("picture.exr", link);
  replace_file(link, [](const fs::path& temporary) { put(temporary, "new"); });
  CHECK(fs::is_symlink(link));
  CHECK(content(target) == "new");
}

TEST_CASE("the new file has the permissions that any new file would have") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr", plain = folder.path / "plain";
  put(plain, "");
  replace_file(target, [](const fs::path&) {});
  CHECK(fs::status(target).permissions() == fs::status(plain).permissions());
}
