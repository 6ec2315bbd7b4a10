#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// The names that may have been meant, at most three, the likeliest first: those that differ by few
/// letters (one wrong, missing, surplus or swapped letter is one step), and those that hold the
/// wanted one or are held in it. Upper and lower case count as equal.
[[nodiscard]] std::vector<std::string> similar_names(std::string_view wanted,
                                                     const std::vector<std::string>& known);

/// "Did you mean a, b or c?", or `otherwise` when nothing is similar.
[[nodiscard]] std::string did_you_mean(std::string_view wanted,
                                       const std::vector<std::string>& known,
                                       const std::string& otherwise);

} // namespace abbe
