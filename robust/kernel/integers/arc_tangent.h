// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The angle of the vector (x, y) from the +x axis, counter-clockwise, in (0, 2 pi), as the nearest double. The vector
/// is neither 0 nor along +x. Uses only integers except for a first guess, whose accuracy does not affect the result.
double angle_rounded(const mpz_class& x, const mpz_class& y);

}  // namespace touchstone::robust::kernel
