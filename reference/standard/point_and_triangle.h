// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/triangles.h"
#include "reference/mixed/closest_point_on_triangle.h"
#include "reference/standard/point_and_segment.h"

/// A point and a triangle. Contracts: reference/mixed/closest_point_on_triangle.h, reference/mixed/sphere_triangle.h.
/// Right in exact arithmetic, but of balls and triangles without an interior that are nearer than the radius, and, by
/// regions, where the textbook formula is not.
namespace touchstone::reference::standard {

/// The foot of the perpendicular on the triangle's plane, if that is within all three edges; otherwise the nearest
/// point of the nearest edge.
struct ByFaceOrEdges {
  template <class Real>
  static Point3<Real> nearest(const Point3<Real>& p, const Triangle3<Real>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3<Real> normal = cross(b - a, c - a);
    const Real square = dot(normal, normal);
    const auto within = [&](const Point3<Real>& from, const Point3<Real>& to) {
      return dot(cross(to - from, p - from), normal) >= Real(0);
    };
    if (square > Real(0) && within(a, b) && within(b, c) && within(c, a))
      return p + Real(-dot(normal, p - a) / square) * normal;
    Point3<Real> nearest = nearest_between_ends<Real>(p, a, b);
    Real least = dot(p - nearest, p - nearest);
    for (const Segment3<Real>& edge : {Segment3<Real>{b, c}, Segment3<Real>{c, a}}) {
      const Point3<Real> x = nearest_between_ends<Real>(p, edge.a, edge.b);
      const Real distance = dot(p - x, p - x);
      if (distance < least) nearest = x, least = distance;
    }
    return nearest;
  }
};

/// Ericson's regions (Real-Time Collision Detection, 5.1.5) as in the textbook formula, the weights in the face times a
/// reciprocal.
struct ByRegions {
  template <class Real>
  static std::array<Real, 2> parts(const Real& x, const Real& y, const Real& total) {
    const Real reciprocal = Real(Real(1) / total);
    return {Real(x * reciprocal), Real(y * reciprocal)};
  }
  template <class Real>
  static Point3<Real> nearest(const Point3<Real>& p, const Triangle3<Real>& triangle) {
    return nearest_of_triangle<Real, ByRegions>(p, triangle);
  }
};

template <class Form, class Real>
ClosestPoint3<Real> closest_point_on_triangle(const Point3<Real>& point, const Triangle3<Real>& triangle) {
  using std::sqrt;
  const Point3<Real> x = Form::nearest(point, triangle);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}

template <class Form, class Real>
Contact sphere_triangle(const Sphere3<Real>& sphere, const Triangle3<Real>& triangle) {
  const Vector3<Real> displacement = Form::nearest(sphere.center, triangle) - sphere.center;
  return contact_within<Real>(dot(displacement, displacement), sphere.radius);
}

}  // namespace touchstone::reference::standard
