#include "io/manual/command_reference.h"

#include <fmt/format.h>

#include <string_view>

namespace abbe {
namespace {

/// The text as a cell of a table: a bar would end the cell, and what stands between angle brackets
/// would be taken for HTML.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '>') result += '\\';
    result += c;
  }
  return result;
}

} // namespace

std::string command_reference(std::span<const CommandFacts> commands) {
  std::string page = "# The command line\n\nThis page is made by `abbe manual reference` from the "
                     "tables that the program reads its own options by.\n";
  for (const CommandFacts& command : commands) {
    page += fmt::format("\n## abbe {}\n\n{}.\n", command.name, command.help);
    if (command.options.empty()) continue;
    page += "\n| option | value | meaning |\n|---|---|---|\n";
    for (const OptionFacts& option : command.options)
      page += fmt::format("| `{}` | {} | {} |\n", fmt::join(option.names, "`, `"),
                          cell(option.positional ? "" : option.value), cell(option.help));
  }
  return page;
}

} // namespace abbe
