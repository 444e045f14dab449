// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every header of robust/ includes this one. -ffast-math lets a compiler assume that there is no NaN and reassociate
// sums; the filters rest on both. (Contraction to FMA, any optimisation level and any rounding mode are fine.)
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "touchstone/robust does not hold under -ffast-math, -Ofast or -ffinite-math-only"
#endif

// -funsafe-math-optimizations does the same by -fassociative-math, and divides otherwise by -freciprocal-math. g++ says
// so from 12 on; clang does not: there nothing but this comment and the README can refuse it. (-fno-signed-zeros, which
// is part of it, and -fno-trapping-math are fine: signs are read from bits.)
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "touchstone/robust does not hold under -funsafe-math-optimizations, -fassociative-math or -freciprocal-math"
#endif
