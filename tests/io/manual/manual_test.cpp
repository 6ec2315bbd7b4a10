#include "tests/catch.h"
#include "tests/io/run_program.h"

using namespace abbe;
using test::Desk;

namespace {

/// The names of all commands, as the program's own help lists them.
std::vector<std::string> commands(const Desk& desk) {
  const std::string help = desk.run("--help");
  std::vector<std::string> names;
  for (std::size_t at = help.find("\n  ", help.find("Subcommands:")); at != std::string::npos;
       at = help.find("\n  ", at + 1))
    if (help[at + 3] != ' ') names.push_back(help.substr(at + 3, help.find(' ', at + 3) - at - 3));
  return names;
}

/// What bash offers for the last word of a line.
std::string completed(const Desk& desk, const std::string& line) {
  return desk
      .shell("\"$abbe\" manual bash >completion && bash -c '. ./completion; COMP_WORDS=(" + line +
             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _abbe; echo \"${COMPREPLY[*]}\"'")
      .out;
}

} // namespace

TEST_CASE("the man page, the completions and the page of commands know every command") {
  const Desk desk;
  const std::vector<std::string> names = commands(desk);
  REQUIRE(names.size() > 10);
  for (const std::string kind : {"man", "reference", "bash", "zsh", "fish"}) {
    const std::string text = desk.run("manual " + kind);
    for (const std::string& name : names) {
      INFO(kind << ": " << name);
      CHECK(text.find(name) != std::string::npos);
    }
    // A switch of render, as an option of that shell.
    const std::string option = kind == "man"    ? "\\-\\-lenient"
                               : kind == "fish" ? "-l lenient"
                                                : "--lenient";
    CHECK(text.find(option) != std::string::npos);
  }
  desk.refuses("manual powershell", "bash");
  desk.refuses("manual", "kind");
}

TEST_CASE("bash completes commands, options, their words and files") {
  const Desk desk;
  CHECK(completed(desk, "abbe rel") == "relight\n");
  CHECK(completed(desk, "abbe render --adapti") == "--adaptive\n");
  CHECK(completed(desk, "abbe render --integrator pa") == "path\n");
  test::put(desk / "prism.sdl", "");
  CHECK(completed(desk, "abbe plan pri") == "prism.sdl\n");
}

TEST_CASE("the page of commands in the documents is that of this program") {
  const Desk desk;
  CHECK(test::content(ABBE_SOURCE_DIR "/docs/command_line.md") == desk.run("manual reference"));
}
