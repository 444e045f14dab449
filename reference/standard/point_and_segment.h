// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/closest.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"

/// A point and a segment, which may be a point (Ericson, Real-Time Collision Detection, 5.1.2). Contracts:
/// reference/mixed/closest_point_on_segment.h, reference/mixed/sphere_capsule.h. Right in exact arithmetic, but of
/// capsules without an interior.
namespace touchstone::reference::standard {

/// Divides only between the ends.
template <class Real, class Point>
Point nearest_between_ends(const Point& p, const Point& a, const Point& b) {
  const auto v = b - a;
  const Real along = dot(p - a, v), length = dot(v, v);
  if (along <= Real(0)) return a;
  if (along >= length) return b;
  return a + Real(along / length) * v;
}

template <class Real>
ClosestPoint2<Real> closest_point_on_segment(const Point2<Real>& point, const Segment2<Real>& segment) {
  using std::sqrt;
  const Point2<Real> x = nearest_between_ends<Real>(point, segment.a, segment.b);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}
template <class Real>
ClosestPoint3<Real> closest_point_on_segment(const Point3<Real>& point, const Segment3<Real>& segment) {
  using std::sqrt;
  const Point3<Real> x = nearest_between_ends<Real>(point, segment.a, segment.b);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}

template <class Real>
Contact contact_within(const Real& squared_distance, const Real& reach) {
  const Real square = Real(reach * reach);
  return squared_distance > square   ? Contact::disjoint
         : squared_distance < square ? Contact::overlapping
                                     : Contact::touching;
}

template <class Real>
Contact sphere_capsule_by_nearest_point(const Sphere3<Real>& sphere, const Capsule3<Real>& capsule) {
  const Vector3<Real> displacement =
      nearest_between_ends<Real>(sphere.center, capsule.segment.a, capsule.segment.b) - sphere.center;
  return contact_within<Real>(dot(displacement, displacement), Real(sphere.radius + capsule.radius));
}

/// Pythagoras subtracts the square of the part along the segment from that of the full displacement; no nearest point
/// is computed.
template <class Real>
Contact sphere_capsule_by_squares(const Sphere3<Real>& sphere, const Capsule3<Real>& capsule) {
  const auto& [a, b] = capsule.segment;
  const Vector3<Real> v = b - a, from_a = sphere.center - a, from_b = sphere.center - b;
  const Real along = dot(from_a, v), length = dot(v, v), whole = dot(from_a, from_a);
  const Real square = along <= Real(0)  ? whole
                      : along >= length ? dot(from_b, from_b)
                                        : Real(whole - Real(Real(along * along) / length));
  return contact_within<Real>(square, Real(sphere.radius + capsule.radius));
}

}  // namespace touchstone::reference::standard
