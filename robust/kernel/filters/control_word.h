// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace touchstone::robust::kernel {

/// Sets IEEE arithmetic as the standard has it (round to nearest, gradual underflow, no traps) while in scope, then
/// restores the host's settings and exception flags. One shared library linked with -Ofast is enough to make a host
/// flush to zero.
class ControlWord {
 public:
#if defined(__SSE2__)
  ControlWord() : host_(_mm_getcsr()) {
    if ((host_ & ~exception_flags) != ieee) _mm_setcsr(ieee);
  }
  ~ControlWord() { _mm_setcsr(host_); }
#else
  ControlWord() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~ControlWord() { std::fesetenv(&host_); }
#endif
  ControlWord(const ControlWord&) = delete;
  ControlWord& operator=(const ControlWord&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned ieee = 0x1f80, exception_flags = 0x3f;
  unsigned host_;
#else
  std::fenv_t host_;
#endif
};

}  // namespace touchstone::robust::kernel
