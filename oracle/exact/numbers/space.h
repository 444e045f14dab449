// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "oracle/exact/numbers/decode.h"

/// Shapes of space over rationals.
namespace touchstone::oracle {

using IntegerPoint = Point3<Integer>;
using IntegerVector = Vector3<Integer>;

template <class Number>
Point3<Rational> exact(const Point3<Number>& p) {
  return {exact(p.x), exact(p.y), exact(p.z)};
}
template <class Number>
Plane<Rational> exact(const Plane<Number>& plane) {
  return {{exact(plane.normal.x), exact(plane.normal.y), exact(plane.normal.z)}, exact(plane.offset)};
}

template <class Number>
bool zero(const Vector3<Number>& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

/// N . p + d: positive in front, in units of the normal's length.
inline Rational height_over(const Plane<Rational>& plane, const Point3<Rational>& p) {
  const auto& n = plane.normal;
  return Rational(n.x * p.x + n.y * p.y + n.z * p.z + plane.offset);
}

}  // namespace touchstone::oracle
