#include "io/commands/check_memory.h"

#include "core/scene/user_error.h"
#include "io/files/available_memory.h"

#include <fmt/format.h>

namespace abbe {

void check_memory(std::uint64_t need, std::optional<double> limit_gib) {
  constexpr double kGiB = 1 << 30;
  const std::uint64_t limit =
      limit_gib ? static_cast<std::uint64_t>(*limit_gib * kGiB) : available_memory();
  const std::uint64_t held = limit_gib ? memory_in_use() : 0; // what is available lacks it already
  if (need <= limit && held <= limit - need) return;
  if (need <= limit)
    throw UserError(fmt::format(
        "the scene takes {} of memory and the picture needs {} more, and the limit is {}, which "
        "--limit-memory sets. Make them smaller, or render parts of the picture with --crop",
        memory_text(held), memory_text(need), memory_text(limit)));
  throw UserError(
      fmt::format("the picture needs {} of memory, and the limit is {}, {}. Make it smaller, or "
                  "render parts of it with --crop{}",
                  memory_text(need), memory_text(limit),
                  limit_gib ? "which --limit-memory sets" : "which is what this machine has left",
                  limit_gib ? "" : "; --limit-memory sets another limit"));
}

} // namespace abbe
