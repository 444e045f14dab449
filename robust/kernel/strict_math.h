// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every header of robust/ includes this one. -ffast-math lets a compiler assume that there is no NaN and reassociate
// sums; the filters rest on both. (Contraction to FMA, any optimisation level and any rounding mode are fine.)
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "touchstone/robust does not hold under -ffast-math, -Ofast or -ffinite-math-only"
#endif
