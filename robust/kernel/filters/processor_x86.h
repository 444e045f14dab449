// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/two_and_four.h"

/// x86-64, and its predecessors with SSE2: MXCSR.
namespace touchstone::robust::kernel::processor {

struct Control {
  unsigned bits;
  friend bool operator==(Control, Control) = default;
};

inline constexpr unsigned all_flags = 0x3f, all_masks = 0x1f80;
inline constexpr unsigned rounding_mode = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
inline constexpr bool can_flush = true;

inline Control control() { return {__builtin_ia32_stmxcsr()}; }
inline void set_control(Control c) { __builtin_ia32_ldmxcsr(c.bits); }
inline bool is_ieee(Control c) { return (c.bits & ~all_flags) == all_masks; }
inline void set_ieee() { set_control({all_masks}); }
inline bool plain_arithmetic() { return (control().bits & (rounding_mode | flush_to_zero | denormals_are_zero)) == 0; }
inline Control masked(Control c) { return {c.bits | all_masks}; }
inline Control unmasked(Control c) { return {c.bits & ~all_masks}; }
inline Control with_flags(Control c, unsigned flags) { return {(c.bits & ~all_flags) | flags}; }
inline Control in_environment(Control c, unsigned rounding, bool results, bool operands) {
  return {(c.bits & ~(rounding_mode | flush_to_zero | denormals_are_zero)) | rounding << 13 |
          (results ? flush_to_zero : 0) | (operands ? denormals_are_zero : 0)};
}

inline double at_run_time(double x) {
  asm volatile("" : "+x"(x));
  return x;
}
inline bool both(TwoBits b) { return __builtin_ia32_movmskpd(reinterpret_cast<TwoNumbers>(b)) == 3; }
inline unsigned signs(TwoBits b) {
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<FourFloats>(b)));
}

}  // namespace touchstone::robust::kernel::processor
