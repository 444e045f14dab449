// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/kernel/filters/two_and_four.h"

/// 64-bit Arm: FPCR says how instructions round, flush and trap, FPSR has their flags.
namespace touchstone::robust::kernel::processor {

struct Control {
  std::uint64_t settings, flags;
  friend bool operator==(Control, Control) = default;
};

/// Many processors have no traps: what is written to `all_traps` reads as 0 there. `flush_to_zero` is for results and
/// operands, and every processor has it; `alternative` changes its meaning on those with FEAT_AFP, for emulators of
/// other processors.
inline constexpr unsigned all_flags = 0x9f;
inline constexpr std::uint64_t all_traps = 0x9f00, rounding_mode = 0xc00000, flush_to_zero = 0x1000000, alternative = 7;
inline constexpr bool can_flush = true;

inline Control control() {
  Control c;
  asm volatile("mrs %0, fpcr" : "=r"(c.settings) : : "memory");
  asm volatile("mrs %0, fpsr" : "=r"(c.flags) : : "memory");
  return c;
}
inline void set_control(Control c) {
  asm volatile("msr fpcr, %0" : : "r"(c.settings) : "memory");
  asm volatile("msr fpsr, %0" : : "r"(c.flags) : "memory");
}
inline bool is_ieee(Control c) { return c.settings == 0; }
inline void set_ieee() { set_control({0, 0}); }
inline bool plain_arithmetic() { return (control().settings & (rounding_mode | flush_to_zero | alternative)) == 0; }
inline Control masked(Control c) { return {c.settings & ~all_traps, c.flags}; }
inline Control unmasked(Control c) { return {c.settings | all_traps, c.flags}; }
inline Control with_flags(Control c, unsigned flags) {
  return {c.settings, (c.flags & ~std::uint64_t{all_flags}) | flags};
}
inline Control in_environment(Control c, unsigned rounding, bool results, bool operands) {
  const std::uint64_t mode = rounding == 1 ? 2 : rounding == 2 ? 1 : rounding;  // upwards comes before downwards here
  return {(c.settings & ~(rounding_mode | flush_to_zero | alternative)) | mode << 22 |
              (results || operands ? flush_to_zero : 0),
          c.flags};
}

inline double at_run_time(double x) {
  asm volatile("" : "+w"(x));
  return x;
}
inline bool both(TwoBits b) { return (b[0] & b[1]) != 0; }
inline unsigned signs(TwoBits b) {
  const FourIntegers each = (reinterpret_cast<FourIntegers>(b) < 0) & FourIntegers{1, 2, 4, 8};
  return static_cast<unsigned>(each[0] | each[1] | each[2] | each[3]);
}

}  // namespace touchstone::robust::kernel::processor
