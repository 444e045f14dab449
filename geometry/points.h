// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/members.h"

namespace touchstone {

/// A displacement in the plane. Real: any number type; finite binary64 wherever `robust` or `oracle` is asked.
template <class Real>
struct Vector2 {
  Real x, y;
  static constexpr auto members = as_list("x", "y").of(Meaning::direction);
};

/// A position in the plane. Points are not vectors: point - point is a vector, point + vector is a point, point + point
/// does not compile.
template <class Real>
struct Point2 {
  Real x, y;
  static constexpr auto members = as_list("x", "y").of(Meaning::place);
  friend bool operator==(const Point2& a, const Point2& b) { return a.x == b.x && a.y == b.y; }
};

using Point2d = Point2<double>;
using Vector2d = Vector2<double>;

template <class Real>
Vector2<Real> operator-(const Point2<Real>& a, const Point2<Real>& b) {
  return {Real(a.x - b.x), Real(a.y - b.y)};
}

template <class Real>
Point2<Real> operator+(const Point2<Real>& p, const Vector2<Real>& v) {
  return {Real(p.x + v.x), Real(p.y + v.y)};
}

template <class Real>
Vector2<Real> operator*(const Real& t, const Vector2<Real>& v) {
  return {Real(t * v.x), Real(t * v.y)};
}

/// v.x * w.x + v.y * w.y
template <class Real>
Real dot(const Vector2<Real>& v, const Vector2<Real>& w) {
  return Real(v.x * w.x + v.y * w.y);
}

/// v.x * w.y - v.y * w.x: twice the area of the triangle (0, v, w), positive when w is counter-clockwise from v (y up).
template <class Real>
Real cross(const Vector2<Real>& v, const Vector2<Real>& w) {
  return Real(v.x * w.y - v.y * w.x);
}

}  // namespace touchstone
