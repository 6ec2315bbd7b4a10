#include "io/manual/command_facts.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace abbe {

std::vector<std::string> choices(const OptionFacts& option) {
  std::vector<std::string> words;
  std::string_view rest = option.value;
  while (true) {
    const std::size_t end = rest.find('|');
    const std::string_view word = rest.substr(0, end);
    // A word in capitals or with a mark stands for a value, such as NAME, and x,y.
    if (word.empty() || !std::ranges::all_of(word, [](unsigned char c) {
          return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-';
        }))
      return {};
    words.emplace_back(word);
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return words.size() > 1 ? words : std::vector<std::string>{};
}

bool takes_file(const OptionFacts& option) {
  for (const std::string_view word : {"FILE", "SCENE", "PICTURE", "STATE", "PART", "CUBE"})
    if (option.value.find(word) != std::string::npos) return true;
  return false;
}

} // namespace abbe
