#include "io/text/name_index.h"

namespace abbe {

std::string lower_case(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lowered;
}

std::optional<std::size_t> NameIndex::find(std::string_view name) const {
  const auto found = numbers_.find(lower_case(name));
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

bool NameIndex::add(std::string_view name, std::size_t number) {
  return numbers_.emplace(lower_case(name), number).second;
}

} // namespace abbe
