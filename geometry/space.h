// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/rules.h"

namespace touchstone {

/// A displacement in space.
template <class Real>
struct Vector3 {
  Real x, y, z;
  static constexpr auto members = as_list("x", "y", "z").of(Meaning::direction);
};

/// A position in space; y is up.
template <class Real>
struct Point3 {
  Real x, y, z;
  static constexpr auto members = as_list("x", "y", "z").of(Meaning::place);
  friend bool operator==(const Point3& a, const Point3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

/// The points p with normal . p + offset = 0; its front is where the sum is positive. The normal has any length but 0,
/// which is refused.
template <class Real>
struct Plane {
  Vector3<Real> normal;
  Real offset;
  static constexpr auto members = as_record("normal", "offset");
  bool rules(const auto& check) const { return check("normal", rule::normal(normal)); }
};

/// A closed ring of at least three vertices in space; the last is joined to the first. Fewer are refused.
template <class Real>
struct Polygon3 {
  std::vector<Point3<Real>> vertices;
  static constexpr auto members = as_bare("vertices");
  bool rules(const auto& check) const { return check("", rule::ring(vertices)); }
  std::size_t size() const { return vertices.size(); }
  const Point3<Real>& operator[](std::size_t i) const { return vertices[i]; }
  const Point3<Real>& next(std::size_t i) const { return vertices[i + 1 == vertices.size() ? 0 : i + 1]; }
};

using Vector3d = Vector3<double>;
using Point3d = Point3<double>;
using Plane3d = Plane<double>;
using Polygon3d = Polygon3<double>;

template <class Real>
Vector3<Real> operator-(const Point3<Real>& a, const Point3<Real>& b) {
  return {Real(a.x - b.x), Real(a.y - b.y), Real(a.z - b.z)};
}

template <class Real>
Point3<Real> operator+(const Point3<Real>& p, const Vector3<Real>& v) {
  return {Real(p.x + v.x), Real(p.y + v.y), Real(p.z + v.z)};
}

template <class Real>
Vector3<Real> operator+(const Vector3<Real>& v, const Vector3<Real>& w) {
  return {Real(v.x + w.x), Real(v.y + w.y), Real(v.z + w.z)};
}

template <class Real>
Vector3<Real> operator-(const Vector3<Real>& v, const Vector3<Real>& w) {
  return {Real(v.x - w.x), Real(v.y - w.y), Real(v.z - w.z)};
}

template <class Real>
Vector3<Real> operator*(const Real& t, const Vector3<Real>& v) {
  return {Real(t * v.x), Real(t * v.y), Real(t * v.z)};
}

template <class Real>
Real dot(const Vector3<Real>& v, const Vector3<Real>& w) {
  return Real(v.x * w.x + v.y * w.y + v.z * w.z);
}

template <class Real>
Vector3<Real> cross(const Vector3<Real>& v, const Vector3<Real>& w) {
  return {Real(v.y * w.z - v.z * w.y), Real(v.z * w.x - v.x * w.z), Real(v.x * w.y - v.y * w.x)};
}

}  // namespace touchstone
