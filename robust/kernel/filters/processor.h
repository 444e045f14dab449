// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

// Processors differ in the control word of floating-point instructions and in the few instructions that C++ has no name
// for. The file of each has these names:
//
//   Control                 how instructions round, flush and trap, and the flags that they have raised
//   control(), set_control(c)
//   is_ieee(c), set_ieee()  what a program starts with, apart from flags: to nearest, no flushing, no traps
//   plain_arithmetic()      whether results are rounded to nearest and nothing is flushed
//   masked(c), unmasked(c)  c with all exceptions masked; with all unmasked, if the processor can trap
//   with_flags(c, flags)    c with these flags raised and no others; `all_flags` are all
//   in_environment(c, rounding, results, operands)
//                           c with a rounding mode (0 to nearest, 1 downwards, 2 upwards, 3 towards zero), and with
//                           subnormal results, or operands, flushed to zero; there may be one switch for both
//   can_flush               whether there is one
//   at_run_time(x)          x, about which the compiler then knows nothing
//   both(b)                 whether all bits of two lanes are set, if each has none or all
//   signs(b)                the signs of four integers in it, as four bits
#if defined(__SSE2__)
#include "robust/kernel/filters/processor_x86.h"
#elif defined(__aarch64__)
#include "robust/kernel/filters/processor_aarch64.h"
#else
#include "robust/kernel/filters/processor_any.h"
#endif
