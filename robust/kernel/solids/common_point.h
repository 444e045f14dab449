// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robust/kernel/shapes/nearest_points.h"

namespace touchstone::robust::kernel {

/// The common point of two convex sets that is nearest to another point. Each set is the hull of some points, all in
/// one plane with that normal, and a common point exists. `to` need not be in the plane.
QuotientPoint nearest_common_point(std::vector<IntegerPoint> a, std::vector<IntegerPoint> b,
                                   const Vector3<mpz_class>& normal, const IntegerPoint& to);

}  // namespace touchstone::robust::kernel
