#include "io/commands/manual_command.h"

#include "io/console/terminal.h"
#include "io/manual/command_reference.h"
#include "io/manual/man_page.h"
#include "io/manual/shell_completion.h"
#include "io/states/state_info.h"

#include <CLI/CLI.hpp>

namespace abbe {

void add_options(CLI::App& app, ManualCommand& command) {
  app.add_option("kind", command.kind,
                 "What to print: man (for man 1 abbe), reference (Markdown), or the completion of "
                 "bash, zsh or fish")
      ->required()
      ->type_name("man|reference|bash|zsh|fish")
      ->check(CLI::IsMember({"man", "reference", "bash", "zsh", "fish"}).description(""));
}

int run(const ManualCommand& command) {
  if (command.kind == "man")
    say(man_page(command.commands, program_version()));
  else if (command.kind == "reference")
    say(command_reference(command.commands));
  else if (command.kind == "bash")
    say(bash_completion(command.commands));
  else if (command.kind == "zsh")
    say(zsh_completion(command.commands));
  else
    say(fish_completion(command.commands));
  return 0;
}

} // namespace abbe
