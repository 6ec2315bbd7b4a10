#pragma once

#include "io/manual/command_facts.h"

#include <span>
#include <string>

namespace abbe {

/// A script that makes bash complete the names of commands, options, the words that an option
/// takes, and files.
[[nodiscard]] std::string bash_completion(std::span<const CommandFacts> commands);

/// The same for zsh, with the help beside each name.
[[nodiscard]] std::string zsh_completion(std::span<const CommandFacts> commands);

/// The same for fish.
[[nodiscard]] std::string fish_completion(std::span<const CommandFacts> commands);

} // namespace abbe
