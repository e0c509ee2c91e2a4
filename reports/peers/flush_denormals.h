// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point mode that Embree asks for, for as long as it runs and no longer.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace gnomon::reports {

/// Sets flush-to-zero and denormals-are-zero for this thread, as Embree's manual recommends for speed, and
/// restores the register as it was: with these modes no promise of ours would hold.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero);
  }
  ~FlushDenormals() {
    _mm_setcsr(before_);
  }
#else
  FlushDenormals() {}
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  // Bits 15 and 6 of MXCSR: Intel SDM, volume 1, 10.2.3.
  static constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  unsigned before_;
#endif
};

}  // namespace gnomon::reports
