#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace abbe {

/// Numbers by names, which are the same in upper and lower case (of ASCII letters).
class NameIndex {
public:
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// False, and nothing done, where the name is there already.
  bool add(std::string_view name, std::size_t number);

private:
  std::unordered_map<std::string, std::size_t> numbers_; ///< by names in lower case
};

/// The text with its ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

} // namespace abbe
