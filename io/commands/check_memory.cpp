#include "io/commands/check_memory.h"

#include "core/scene/user_error.h"
#include "io/console/terminal.h"
#include "io/files/available_memory.h"

#include <fmt/format.h>

namespace abbe {

void check_memory(MemoryNeed need, std::optional<double> limit_gib) {
  constexpr double kGiB = 1 << 30;
  const std::uint64_t limit =
      limit_gib ? static_cast<std::uint64_t>(*limit_gib * kGiB) : available_memory();
  const std::uint64_t held = limit_gib ? memory_in_use() : 0; // what is available lacks it already
  if (need.bytes <= limit && held <= limit - need.bytes) return;
  if (need.bytes <= limit)
    throw UserError(fmt::format("the scene takes {} of memory and {} needs {} more, and the limit "
                                "is {}, which --limit-memory sets. {}",
                                memory_text(held), need.what, memory_text(need.bytes),
                                memory_text(limit), need.cure));
  throw UserError(
      fmt::format("{} needs {} of memory, and the limit is {}, {}. {}{}", need.what,
                  memory_text(need.bytes), memory_text(limit),
                  limit_gib ? "which --limit-memory sets" : "which is what this machine has left",
                  need.cure, limit_gib ? "" : "; --limit-memory sets another limit"));
}

void tell_disk(std::uint64_t bytes, const BandPlace& place) {
  if (bytes == 0) return;
  say(fmt::format("plan: {} of sums lie in files without a name in {} while it is rendered",
                  memory_text(bytes), place.folder.string()));
}

} // namespace abbe
