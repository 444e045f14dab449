// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_aabb.h"

/// Rays and segments against the slabs of a box, each time by one product or quotient. Contracts:
/// reference/mixed/ray_aabb.h, reference/mixed/segment_aabb.h. Right in exact arithmetic, and there the same as those.
namespace touchstone::reference::standard {

/// Kay and Kajiya's slabs with the reciprocal of the direction, which programs keep for all boxes that a ray is tried
/// with.
struct ByReciprocalDirection {
  template <class Real>
  static void cut(SlabTimes<Real>& times, const Real& from, const Real& displacement, const Real& min,
                  const Real& max) {
    if (displacement == Real(0)) return times.cut(from, displacement, min, max);
    const Real reciprocal = Real(Real(1) / displacement);
    times.narrow(displacement, Real(Real(min - from) * reciprocal), Real(Real(max - from) * reciprocal));
  }
};

/// From the box's center, half its size before and behind.
struct ByHalfExtents {
  template <class Real>
  static void cut(SlabTimes<Real>& times, const Real& from, const Real& displacement, const Real& min,
                  const Real& max) {
    if (displacement == Real(0)) return times.cut(from, displacement, min, max);
    const Real two(2), to_center = Real(Real(Real(min + max) / two) - from), half = Real(Real(max - min) / two);
    times.narrow(displacement, Real(Real(to_center - half) / displacement),
                 Real(Real(to_center + half) / displacement));
  }
};

template <class Form, class Real>
void cut_all(SlabTimes<Real>& times, const Point2<Real>& p, const Vector2<Real>& v, const Aabb2<Real>& box) {
  Form::cut(times, p.x, v.x, box.min.x, box.max.x), Form::cut(times, p.y, v.y, box.min.y, box.max.y);
}
template <class Form, class Real>
void cut_all(SlabTimes<Real>& times, const Point3<Real>& p, const Vector3<Real>& v, const Aabb3<Real>& box) {
  Form::cut(times, p.x, v.x, box.min.x, box.max.x), Form::cut(times, p.y, v.y, box.min.y, box.max.y);
  Form::cut(times, p.z, v.z, box.min.z, box.max.z);
}

template <class Form, class Real>
Passage<Real> ray_aabb(const Ray2<Real>& ray, const Aabb2<Real>& aabb) {
  SlabTimes<Real> times;
  cut_all<Form>(times, ray.origin, ray.direction, aabb);
  return times.passage();
}
template <class Form, class Real>
Passage<Real> ray_aabb(const Ray3<Real>& ray, const Aabb3<Real>& aabb) {
  SlabTimes<Real> times;
  cut_all<Form>(times, ray.origin, ray.direction, aabb);
  return times.passage();
}

template <class Form, class Real>
Passage<Real> segment_aabb(const Segment2<Real>& segment, const Aabb2<Real>& aabb) {
  SlabTimes<Real> times{Real(0), Real(1)};
  cut_all<Form>(times, segment.a, segment.b - segment.a, aabb);
  return times.passage();
}
template <class Form, class Real>
Passage<Real> segment_aabb(const Segment3<Real>& segment, const Aabb3<Real>& aabb) {
  SlabTimes<Real> times{Real(0), Real(1)};
  cut_all<Form>(times, segment.a, segment.b - segment.a, aabb);
  return times.passage();
}

}  // namespace touchstone::reference::standard
