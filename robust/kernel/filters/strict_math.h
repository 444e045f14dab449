// SPDX-License-Identifier: Apache-2.0
#pragma once

// "Every floating-point environment" in the contracts of robust means each of the four rounding modes, results flushed
// to zero or not, subnormal operands read as zero or not (FTZ, DAZ), and every sticky flag set or not, with all
// exceptions masked, as every program starts. Filters round, underflow and overflow on purpose: they set sticky flags,
// and if the host has unmasked an exception they raise it. robust/masked_exceptions.h is for such hosts.

// Every header of robust/ includes this one. -ffast-math lets a compiler assume that there is no NaN and reassociate
// sums; the filters rest on both. (Contraction to FMA, any optimisation level and any rounding mode are fine.)
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "touchstone/robust does not hold under -ffast-math, -Ofast or -ffinite-math-only"
#endif

// x87 rounds a double to 64 bits, and again when it is stored.
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "touchstone/robust does not hold in x87 arithmetic: -msse2 -mfpmath=sse"
#endif

// -funsafe-math-optimizations does the same by -fassociative-math, and changes divisions by -freciprocal-math. g++
// defines macros for these from version 12 on; clang does not: there only this comment and the README can warn.
// (-fno-signed-zeros, which is part of it, and -fno-trapping-math are fine: signs are read from bits.)
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "touchstone/robust does not hold under -funsafe-math-optimizations, -fassociative-math or -freciprocal-math"
#endif
