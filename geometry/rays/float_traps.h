#pragma once

// In a build with ABBE_TRAPS (the preset `traps`) an invalid operation, a division by zero or an
// overflow ends the program where it happens. In all others the classes do nothing.

#ifdef ABBE_TRAPS
#include <immintrin.h>
#endif

namespace abbe {

#ifdef ABBE_TRAPS

/// While it lives, this thread's traps are on (in a callback of a library, say) or off (around a
/// call of a library, whose results are judged and not its ways).
class FloatTraps {
public:
  explicit FloatTraps(bool on) : saved_(_mm_getcsr()) {
    const unsigned without_flags = saved_ & ~unsigned{_MM_EXCEPT_MASK};
    _mm_setcsr(on ? without_flags & ~kTrapped : without_flags | kTrapped);
  }
  ~FloatTraps() { _mm_setcsr(saved_ & ~unsigned{_MM_EXCEPT_MASK}); }
  FloatTraps(const FloatTraps&) = delete;
  FloatTraps& operator=(const FloatTraps&) = delete;

private:
  static constexpr unsigned kTrapped = _MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW;
  unsigned saved_;
};

#else

class FloatTraps {
public:
  explicit constexpr FloatTraps(bool) {}
};

#endif

} // namespace abbe
