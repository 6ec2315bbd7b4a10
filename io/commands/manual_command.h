#pragma once

#include "io/manual/command_facts.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Prints the man page, the completion of a shell, or the page of all commands, from the tables by
/// which the command line is read.
struct ManualCommand {
  static constexpr const char* kName = "manual";
  static constexpr const char* kHelp =
      "Print the man page, a shell's completion or the page of all commands";

  std::string kind;                   ///< "man", "reference", "bash", "zsh" or "fish"
  std::vector<CommandFacts> commands; ///< all that the program has
};
void add_options(CLI::App& app, ManualCommand& command);
[[nodiscard]] int run(const ManualCommand& command);

} // namespace abbe
