// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// `level`: at least one vertex, all of the same height along the direction. If no vertex is lower, returns these and
/// all others of that height; otherwise one that is lower.
std::vector<Index> lowest_vertices(const std::vector<Point3d>& vertices, std::vector<Index> level,
                                   const Vector3<mpz_class>& direction);

}  // namespace touchstone::robust::kernel
