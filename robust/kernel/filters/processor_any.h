// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>

#include "robust/kernel/filters/two_and_four.h"

/// Any other processor, as far as the C library knows it. The library cannot say whether a processor flushes, and only
/// GNU's whether exceptions trap; it can mask them, and not unmask them.
namespace touchstone::robust::kernel::processor {

struct Control {
  std::fenv_t all;
  bool may_trap;
  int rounding;
  unsigned flags;
  friend bool operator==(const Control& a, const Control& b) { return a.rounding == b.rounding && a.flags == b.flags; }
};

inline constexpr unsigned all_flags = FE_ALL_EXCEPT;
inline constexpr bool can_flush = false;

inline bool may_trap() {
#ifdef __GLIBC__
  return ::fegetexcept() != 0;
#else
  return true;
#endif
}
inline Control control() {
  Control c{{}, may_trap(), std::fegetround(), static_cast<unsigned>(std::fetestexcept(FE_ALL_EXCEPT))};
  std::fegetenv(&c.all);
  return c;
}
inline void set_control(const Control& c) {
  std::fesetenv(c.may_trap ? &c.all : FE_DFL_ENV);
  std::fesetround(c.rounding);
  std::feclearexcept(FE_ALL_EXCEPT);
  std::feraiseexcept(static_cast<int>(c.flags));
}
inline bool is_ieee(const Control& c) { return c.rounding == FE_TONEAREST && !c.may_trap; }
inline void set_ieee() { std::fesetenv(FE_DFL_ENV); }
inline bool plain_arithmetic() { return std::fegetround() == FE_TONEAREST; }
inline Control masked(Control c) {
  c.may_trap = false;
  return c;
}
inline Control unmasked(const Control& c) { return c; }
inline Control with_flags(Control c, unsigned flags) {
  c.flags = flags & all_flags;
  return c;
}
inline Control in_environment(Control c, unsigned rounding, bool, bool) {
  constexpr int modes[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
  c.rounding = modes[rounding];
  return c;
}

inline double at_run_time(double x) {
  volatile double kept = x;
  return kept;
}
inline bool both(TwoBits b) { return (b[0] & b[1]) != 0; }
inline unsigned signs(TwoBits b) {
  const FourIntegers f = reinterpret_cast<FourIntegers>(b);
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= static_cast<unsigned>(f[k] < 0) << k;
  return bits;
}

}  // namespace touchstone::robust::kernel::processor
