// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <vector>

#include "geometry/closest.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The distance of the convex hulls of two lists of vertices, with the nearest points that convex_distance returns. The
/// numbers are finite; faces are not read.
ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b);

/// The shortest displacement from the hull of b to that of a: displacement / total * 2^exponent. of_a and of_b: the
/// vertices that are farthest against it and along it, in any order; empty where the hulls meet.
struct Separation {
  Vector3<mpz_class> displacement;
  mpz_class total;
  int exponent;
  std::vector<Index> of_a, of_b;
};
Separation separation_of_solids(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
