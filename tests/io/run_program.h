#pragma once

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace abbe::test {

/// What a run of the program came to.
struct Outcome {
  int exit_code = 0;
  std::string out, error;
};

/// A folder in which the program runs.
struct Desk {
  Folder folder;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return folder.path / name;
  }
  /// Runs the shell's command, in which $abbe is the program.
  [[nodiscard]] Outcome shell(const std::string& command) const {
    const std::string all = "cd '" + folder.path.string() + "' && abbe='" ABBE_EXECUTABLE "'; { " +
                            command + "; } >out 2>error";
    const int status = std::system(all.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder.path / "out"),
            content(folder.path / "error")};
  }
  [[nodiscard]] Outcome abbe(const std::string& arguments) const {
    return shell("\"$abbe\" " + arguments);
  }
  /// Runs the program, which must end with 0, and returns what it says on standard output.
  std::string run(const std::string& arguments) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  }
  /// The program must refuse this as a mistake of the user's, and tell why.
  void refuses(const std::string& arguments, const std::string& reason) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.error.find(reason) != std::string::npos);
  }
};

/// The number that follows `name` at the beginning of a line of the text.
[[nodiscard]] inline double number_after(const std::string& text, const std::string& name) {
  const std::size_t at = text.starts_with(name) ? 0 : text.find("\n" + name);
  INFO(name << "\n" << text);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + name.size() + (at == 0 && text.starts_with(name) ? 0 : 1)));
}

} // namespace abbe::test
