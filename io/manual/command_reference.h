#pragma once

#include "io/manual/command_facts.h"

#include <span>
#include <string>

namespace abbe {

/// A page in Markdown with each command and what can be given to it.
[[nodiscard]] std::string command_reference(std::span<const CommandFacts> commands);

} // namespace abbe
