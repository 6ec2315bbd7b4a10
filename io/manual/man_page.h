#pragma once

#include "io/manual/command_facts.h"

#include <span>
#include <string>

namespace abbe {

/// The man page of the program, abbe(1), in the language of man(7).
[[nodiscard]] std::string man_page(std::span<const CommandFacts> commands,
                                   const std::string& version);

} // namespace abbe
