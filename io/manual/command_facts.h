#pragma once

#include <string>
#include <vector>

namespace abbe {

/// What can be given to a command on the command line, as its help tells it.
struct OptionFacts {
  std::vector<std::string> names; ///< with their dashes, such as "-o" and "--output"; of an
                                  ///< argument without dashes, its name alone
  std::string value;              ///< what follows, such as "FILE" or "on|off"; empty of a switch
  std::string help;               ///< one line
  bool positional = false;        ///< an argument that has no dashes
};

/// One command of the program.
struct CommandFacts {
  std::string name;
  std::string help; ///< one line
  std::vector<OptionFacts> options;
};

/// The words that a value may be where it is one of a few ("on|off" is two), or none.
[[nodiscard]] std::vector<std::string> choices(const OptionFacts& option);

/// Whether the value of the option is the name of a file.
[[nodiscard]] bool takes_file(const OptionFacts& option);

} // namespace abbe
