#include "io/text/similar_names.h"

#include "io/text/name_index.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace abbe {
namespace {

constexpr std::size_t kMostNames = 3;
constexpr std::size_t kShortestPart = 3; ///< shorter ones are a part of too many names

bool is_part(const std::string& part, const std::string& whole) {
  return part.size() >= kShortestPart && whole.find(part) != std::string::npos;
}

/// Steps from `a` to `b`: a letter replaced, left out, put in, or swapped with its neighbour, no
/// part of the text being touched twice. Three rows of the table of prefixes are kept.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, above);
    std::swap(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

} // namespace

std::vector<std::string> similar_names(std::string_view wanted,
                                       const std::vector<std::string>& known) {
  const std::string target = lower_case(wanted);
  const std::size_t near = std::max<std::size_t>(1, target.size() / 3);
  std::multimap<std::size_t, std::string> found; // those of one rank stay in their order
  for (const std::string& name : known) {
    const std::string candidate = lower_case(name);
    const auto [shorter, longer] = std::minmax({target.size(), candidate.size()});
    const std::size_t distance = longer - shorter > near // each letter too many is a step
                                     ? longer
                                     : edit_distance(target, candidate);
    const bool part = is_part(target, candidate) || is_part(candidate, target);
    // A whole part counts as nearly as good as one wrong letter.
    if (distance <= near && distance < target.size())
      found.emplace(2 * distance, name);
    else if (part)
      found.emplace(3, name);
  }
  std::vector<std::string> names;
  for (auto& [rank, name] : found)
    if (names.size() < kMostNames) names.push_back(std::move(name));
  return names;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& known,
                         const std::string& otherwise) {
  const std::vector<std::string> names = similar_names(wanted, known);
  if (names.empty()) return otherwise;
  std::string text = "Did you mean " + names.front();
  for (std::size_t i = 1; i < names.size(); ++i)
    text += (i + 1 == names.size() ? " or " : ", ") + names[i];
  return text + '?';
}

} // namespace abbe
