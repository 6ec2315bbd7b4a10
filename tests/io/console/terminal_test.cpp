#include "io/console/terminal.h"

#include "io/outputs/write_each.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace abbe;

namespace {

/// Runs abbe by a shell, where $ABBE is the program; returns its exit code.
int run(const test::Folder& folder, const std::string& command) {
  const std::string whole =
      "cd '" + folder.path.string() + "' && ABBE='" ABBE_EXECUTABLE "' && " + command;
  const int status = std::system(whole.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

void write_scene(const test::Folder& folder) {
  std::ofstream(folder.path / "s.sdl") << "imageSize 8 8 samples 1 bands 1 sphere";
}

} // namespace

TEST_CASE("control characters are escaped, letters of all languages are not") {
  CHECK(escaped("a\x1b[31m\x7f\r\n\tb") == "a\\x1b[31m\\x7f\\x0d\n\tb");
  CHECK(escaped("\xC3\xA4 \xE2\x80\xA6 \xC2\xA9") == "\xC3\xA4 \xE2\x80\xA6 \xC2\xA9");
  CHECK(escaped("\xC2\x9b"
                "31m") == "\\x9b31m");
}

TEST_CASE("one file that cannot be written does not keep the others from it") {
  int written = 0;
  const auto good = [&] {
    ++written;
    return std::string();
  };
  const auto bad = []() -> std::string { throw std::runtime_error("the disk is full"); };
  CHECK_FALSE(write_each({{"a", bad}, {"b", good}, {"c", bad}, {"d", good}}, true));
  CHECK(written == 2);
  CHECK(write_each({{"b", good}}, true));
}

TEST_CASE("what cannot be said does not end the render") {
  const test::Folder folder;
  write_scene(folder);
  for (const char* streams : {"2>&-", "2>/dev/full", ">/dev/null 2>/dev/full"}) {
    CHECK(run(folder, std::string("\"$ABBE\" render s.sdl -o o.exr >out ") + streams) == 0);
    CHECK(std::filesystem::remove(folder.path / "o.exr"));
  }
  for (const char* streams : {">/dev/full", ">&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    CHECK(run(folder, std::string("\"$ABBE\" render s.sdl -o o.exr 2>err ") + streams) == 1);
    CHECK(std::filesystem::remove(folder.path / "o.exr"));
  }
  CHECK(run(folder, "\"$ABBE\" render s.sdl -o o.exr 2>&1 | true") == 0);
  CHECK(std::filesystem::exists(folder.path / "o.exr"));
  CHECK(run(folder, "\"$ABBE\" plan s.sdl >/dev/full 2>err") == 1);
  CHECK(run(folder, "\"$ABBE\" --help >/dev/full 2>err") == 1);
  CHECK(run(folder, "\"$ABBE\" plan s.sdl >out 2>err") == 0);
}

TEST_CASE("an escape sequence in a scene does not reach the terminal") {
  const test::Folder folder;
  std::ofstream(folder.path / "s.sdl") << "use a\x1b[31m";
  CHECK(run(folder, "\"$ABBE\" plan s.sdl >out 2>err") == 2);
  CHECK(test::content(folder.path / "err").find('\x1b') == std::string::npos);
  CHECK(test::content(folder.path / "err").find("a\\x1b[31m") != std::string::npos);
}

TEST_CASE("outputs that cannot be written are refused before the render") {
  const test::Folder folder;
  write_scene(folder);
  REQUIRE(run(folder, "ln -s none dangling.exr; ln -s loop.exr loop.exr; mkfifo pipe.exr; "
                      "touch old.exr; chmod 444 old.exr") == 0);
  for (const std::string name : {"dangling.exr", "loop.exr", "pipe.exr", "old.exr"}) {
    CHECK(run(folder, "\"$ABBE\" render s.sdl -o good.exr -o " + name + " >out 2>err") == 2);
    CHECK(test::content(folder.path / "err").find("cannot write " + name + ": ") !=
          std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder.path / "good.exr"));
  }
}
