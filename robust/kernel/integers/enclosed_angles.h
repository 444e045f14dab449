// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed/enclosed.h"
#include "robust/kernel/enclosed/two.h"

/// Sine, cosine and arc tangent, enclosed; the caller has checked robust/kernel/enclosed/window.h. Uses a table at
/// multiples of 1/256 and short Taylor series between them; the table and pi come from the integers of sine_cosine.h on
/// first use. The bounds are not those of enclosed.h alone. Not proved by machine.
namespace touchstone::robust::kernel {

/// (cos u, sin u); empty beyond 2^20, and if u is so near to a multiple of a quarter turn that too few digits are left.
std::optional<Enclosed<Two>> enclosed_cosine_sine(double u);

/// The angle of the vector (x, y) from the +x axis in (0, 2 pi); empty if a coordinate is not settled, or may be zero.
std::optional<Enclosed<double>> enclosed_angle(const Enclosed<double>& x, const Enclosed<double>& y);

}  // namespace touchstone::robust::kernel
