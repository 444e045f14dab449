// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "geometry/thin_shapes.h"
#include "robust/kernel/filters/strict_math.h"

/// The last stage: CGAL's predicates over GMP integers, behind a guard of the control word. CGAL is compiled only in
/// the file behind this header. The caller has handled degenerate arguments.
namespace touchstone::robust::kernel {

/// 1, 0, -1: p, q, r turn left, lie on one line, turn right.
int turn(const Point2<mpz_class>& p, const Point2<mpz_class>& q, const Point2<mpz_class>& r);

/// 1, 0, -1: w lies counter-clockwise of v, along it, clockwise.
int turn(const Vector2<mpz_class>& v, const Vector2<mpz_class>& w);

/// 1, 0, -1: p lies inside, on, outside the circle. radius >= 0.
int side_of_circle(const Circle2<mpz_class>& circle, const Point2<mpz_class>& p);

/// 1, 0, -1: the sign of x.
int sign_by_cgal(const mpz_class& x);

}  // namespace touchstone::robust::kernel
