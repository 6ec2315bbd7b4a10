#pragma once

#include <immintrin.h>

namespace abbe {

/// While it lives, denormal numbers are flushed to zero on this thread: they are slow and far below
/// any image's precision.
class DenormalsOff {
public:
  DenormalsOff() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }
  ~DenormalsOff() { _mm_setcsr(saved_); }
  DenormalsOff(const DenormalsOff&) = delete;
  DenormalsOff& operator=(const DenormalsOff&) = delete;

private:
  unsigned saved_;
};

} // namespace abbe
