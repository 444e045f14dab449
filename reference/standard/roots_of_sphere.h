// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_sphere.h"
#include "reference/mixed/segment_sphere.h"

/// Rays and segments against a ball by the quadratic formula in two other forms. Contracts:
/// reference/mixed/ray_sphere.h, reference/mixed/segment_sphere.h; in exact arithmetic as right as these.
namespace touchstone::reference::standard {

/// Without the factors 2 and 4: B is half the linear coefficient.
struct ByHalfCoefficient {
  template <class Real, class Vector>
  static RootsOfSphere<Real> roots(const Vector& p, const Vector& v, const Real& r) {
    using std::sqrt;
    const Real a = dot(v, v), b = dot(p, v), c = Real(dot(p, p) - Real(r * r)), d = Real(Real(b * b) - Real(a * c));
    RootsOfSphere<Real> found;
    if (!(Real(0) <= d)) return found;
    const Real root = Real(sqrt(d));
    found.real = true, found.smaller = Real(Real(-b - root) / a), found.greater = Real(Real(root - b) / a);
    return found;
  }
};

/// With a unit direction: distances along the line, divided by the direction's length.
struct ByUnitDirection {
  template <class Real, class Vector>
  static RootsOfSphere<Real> roots(const Vector& p, const Vector& v, const Real& r) {
    using std::sqrt;
    const Real length = Real(sqrt(dot(v, v))), along = dot(p, Real(Real(1) / length) * v);
    const Real d = Real(Real(along * along) - Real(dot(p, p) - Real(r * r)));
    RootsOfSphere<Real> found;
    if (!(Real(0) <= d)) return found;
    const Real root = Real(sqrt(d));
    found.real = true;
    found.smaller = Real(Real(-along - root) / length), found.greater = Real(Real(root - along) / length);
    return found;
  }
};

template <class Form, class Real>
Passage<Real> ray_sphere(const Ray2<Real>& ray, const Circle2<Real>& sphere) {
  return passage_of_ray(Form::roots(ray.origin - sphere.center, ray.direction, sphere.radius));
}
template <class Form, class Real>
Passage<Real> ray_sphere(const Ray3<Real>& ray, const Sphere3<Real>& sphere) {
  return passage_of_ray(Form::roots(ray.origin - sphere.center, ray.direction, sphere.radius));
}

template <class Form, class Real>
Passage<Real> segment_sphere(const Segment2<Real>& segment, const Circle2<Real>& sphere) {
  return passage_of_segment(Form::roots(segment.a - sphere.center, segment.b - segment.a, sphere.radius));
}
template <class Form, class Real>
Passage<Real> segment_sphere(const Segment3<Real>& segment, const Sphere3<Real>& sphere) {
  return passage_of_segment(Form::roots(segment.a - sphere.center, segment.b - segment.a, sphere.radius));
}

}  // namespace touchstone::reference::standard
