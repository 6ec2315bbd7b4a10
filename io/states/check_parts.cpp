#include "io/states/check_parts.h"

#include "core/scene/user_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace abbe {
namespace {

/// In what two parts are not of one rendering; empty where they are.
std::string misfit(const StateInfo& a, const StateInfo& b) {
  if (a.version != b.version)
    return fmt::format("abbe {} has written it, and {} the first", b.version, a.version);
  const auto same = [](const SceneFile& f, const SceneFile& g) {
    return f.size == g.size && f.checksum == g.checksum;
  };
  if (!std::ranges::equal(a.files, b.files, same)) return "it shows another scene";
  if (a.samples != b.samples)
    return fmt::format("it is of {} samples a pixel, and the first of {}", b.samples, a.samples);
  for (std::size_t i = 0; i < std::min(a.settings.size(), b.settings.size()); ++i)
    if (a.settings[i] != b.settings[i])
      return fmt::format("it was rendered with {} {}, and the first with {} {}",
                         b.settings[i].first, b.settings[i].second, a.settings[i].first,
                         a.settings[i].second);
  if (a.settings.size() != b.settings.size()) return "it has other settings";
  if (a.part.count != b.part.count)
    return fmt::format("it is one of {} parts, and the first one of {}", b.part.count,
                       a.part.count);
  return "";
}

/// "3", "1 to 4 and 7", "1, 3 and 5", by the numbers that are in no part.
std::string missing_numbers(const std::map<int, const KeptPart*>& parts, int count) {
  std::vector<std::string> runs;
  for (int number = 0; number < count; ++number) {
    if (parts.contains(number)) continue;
    const int first = number;
    while (number + 1 < count && !parts.contains(number + 1))
      ++number;
    runs.push_back(first == number ? fmt::format("{}", first + 1)
                                   : fmt::format("{} to {}", first + 1, number + 1));
  }
  if (runs.size() < 2) return runs.empty() ? "" : runs.front();
  const std::string last = runs.back();
  runs.pop_back();
  return fmt::format("{} and {}", fmt::join(runs, ", "), last);
}

} // namespace

void check_parts(std::span<const KeptPart> parts) {
  std::map<int, const KeptPart*> by_number;
  const KeptPart& first = parts.front();
  for (const KeptPart& part : parts) {
    if (const std::string reason = misfit(first.info, part.info); !reason.empty())
      throw UserError(fmt::format("{}: this part does not belong to {}: {}", part.file.string(),
                                  first.file.string(), reason));
    const auto [known, is_new] = by_number.emplace(part.info.part.number, &part);
    if (!is_new)
      throw UserError(fmt::format("{} and {} are both part {} of {}", known->second->file.string(),
                                  part.file.string(), part.info.part.number + 1,
                                  part.info.part.count));
    if (!part.complete)
      throw UserError(fmt::format("{}: this part is not complete. Go on with it by --resume",
                                  part.file.string()));
  }
  const std::string missing = missing_numbers(by_number, first.info.part.count);
  if (!missing.empty())
    throw UserError(
        fmt::format("of {} parts, these are missing: {}", first.info.part.count, missing));
}

} // namespace abbe
