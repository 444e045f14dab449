// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/rays.h"

/// A ray or a segment and a triangle by Cramer's rule (Moeller and Trumbore, Fast, minimum storage ray/triangle
/// intersection, 1997). Contracts: reference/mixed/ray_triangle.h, reference/polyhedra/segment_triangle.h. A line that
/// is parallel to the triangle's plane, or in it, has the determinant 0 and no common point, which is wrong of lines in
/// the plane even in exact arithmetic; of all others both forms are right there.
namespace touchstone::reference::standard {

/// The solution of a + u (b - a) + v (c - a) = origin + t direction, all but the determinant times the determinant.
template <class Real>
struct OnTriangle {
  Real determinant, u, v, t;

  OnTriangle(const Point3<Real>& origin, const Vector3<Real>& direction, const Triangle3<Real>& triangle) {
    const Vector3<Real> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, displacement = origin - triangle.a;
    const Vector3<Real> across = cross(direction, ac), turned = cross(displacement, ab);
    determinant = dot(ab, across), u = dot(displacement, across), v = dot(direction, turned), t = dot(ac, turned);
  }
};

/// The t of a common point, and whether it is inside of the triangle's edges.
template <class Real>
struct TriangleHit {
  Real t;
  bool inside;
};

/// `one`: the value of 1 in the scale of u and v.
template <class Real>
std::optional<TriangleHit<Real>> hit_within(const Real& u, const Real& v, const Real& t, const Real& one) {
  const Real zero(0), sum = Real(u + v);
  if (u < zero || v < zero || sum > one) return std::nullopt;
  return TriangleHit<Real>{t, u > zero && v > zero && sum < one};
}

/// As most programs have it: times the reciprocal of the determinant.
struct ByReciprocal {
  template <class Real>
  static std::optional<TriangleHit<Real>> hit(const OnTriangle<Real>& on) {
    if (on.determinant == Real(0)) return std::nullopt;
    const Real reciprocal = Real(Real(1) / on.determinant);
    return hit_within(Real(on.u * reciprocal), Real(on.v * reciprocal), Real(on.t * reciprocal), Real(1));
  }
};

/// Nothing is divided before it is decided that the line meets the triangle.
struct ByDeterminant {
  template <class Real>
  static std::optional<TriangleHit<Real>> hit(const OnTriangle<Real>& on) {
    const auto& [determinant, u, v, t] = on;
    if (determinant == Real(0)) return std::nullopt;
    const bool front = determinant > Real(0);
    const Real quotient = Real(t / determinant);
    return front ? hit_within(u, v, quotient, determinant)
                 : hit_within(Real(-u), Real(-v), quotient, Real(-determinant));
  }
};

template <class Form, class Real>
RayTriangle<Real> ray_triangle(const Ray3<Real>& ray, const Triangle3<Real>& triangle) {
  const auto hit = Form::hit(OnTriangle<Real>(ray.origin, ray.direction, triangle));
  if (!hit || hit->t < Real(0)) return {SegmentTriangleRelation::none, std::nullopt, std::nullopt, std::nullopt};
  return {SegmentTriangleRelation::point, hit->t, ray.origin + hit->t * ray.direction,
          hit->inside ? Location::inside : Location::boundary};
}

template <class Form, class Real>
SegmentTriangle<Real> segment_triangle(const Segment3<Real>& segment, const Triangle3<Real>& triangle) {
  const Vector3<Real> displacement = segment.b - segment.a;
  const auto hit = Form::hit(OnTriangle<Real>(segment.a, displacement, triangle));
  if (!hit || hit->t < Real(0) || hit->t > Real(1))
    return {SegmentTriangleRelation::none, std::nullopt, std::nullopt, std::nullopt};
  return {SegmentTriangleRelation::point, hit->t, segment.a + hit->t * displacement, std::nullopt};
}

}  // namespace touchstone::reference::standard
