// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <vector>

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/closest.h"
#include "geometry/polyhedra.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The distance of the convex hulls of two lists of vertices, with the nearest points that convex_distance returns. The
/// numbers are finite; faces are not read.
ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b);
/// Its two stages. `certain_distance` is empty if floating point does not tell, or if there are several nearest pairs.
Perhaps<ConvexDistance<double>> certain_distance(const Meshd& a, const Meshd& b);
ConvexDistance<double> exact_distance(const Meshd& a, const Meshd& b);

/// The shortest displacement from the hull of b to that of a: displacement / total * 2^exponent. of_a and of_b: the
/// vertices that are farthest against it and along it, in any order; empty where the hulls meet.
struct Separation {
  Vector3<mpz_class> displacement;
  mpz_class total;
  int exponent;
  std::vector<Index> of_a, of_b;
};
Separation separation_of_solids(const Meshd& a, const Meshd& b);

/// Points as a list of vertices: a round solid is all that is no farther than its radius from their hull.
inline Meshd core_of(const Sphere3d& sphere) { return {{sphere.center}, {}, {}}; }
inline Meshd core_of(const Capsule3d& capsule) { return {{capsule.segment.a, capsule.segment.b}, {}, {}}; }
inline Meshd core_of(const Triangle3d& triangle) { return {{triangle.a, triangle.b, triangle.c}, {}, {}}; }

/// The contact of a round solid and a convex one; the radius is not negative. `certain_contact` is empty if floating
/// point does not tell.
Perhaps<Contact> certain_contact(const Meshd& core, double radius, const Meshd& solid);
Contact exact_contact(const Meshd& core, double radius, const Meshd& solid);

}  // namespace touchstone::robust::kernel
