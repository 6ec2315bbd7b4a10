#include "io/files/temporary_names.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>

namespace abbe {
namespace {

enum class SlotState { free, taken, kept };
static_assert(std::atomic<SlotState>::is_always_lock_free, "a signal handler may not lock");

/// A name where a signal handler finds it, which may neither lock nor allocate.
struct Slot {
  std::atomic<SlotState> state = SlotState::free;
  std::array<char, 4096> name{};
};
std::array<Slot, 8> slots;

} // namespace

TemporaryName::TemporaryName(const std::filesystem::path& path) : slot_(slots.size()) {
  const std::string& name = path.native();
  if (name.size() >= slots.front().name.size()) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    SlotState expected = SlotState::free;
    if (!slots[i].state.compare_exchange_strong(expected, SlotState::taken)) continue;
    *std::ranges::copy(name, slots[i].name.begin()).out = '\0';
    slots[i].state = SlotState::kept;
    slot_ = i;
    return;
  }
}

TemporaryName::~TemporaryName() {
  if (slot_ < slots.size()) slots[slot_].state = SlotState::free;
}

void remove_temporary_files() noexcept {
  for (const Slot& slot : slots)
    if (slot.state == SlotState::kept) ::unlink(slot.name.data());
}

} // namespace abbe
