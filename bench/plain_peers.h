// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "catalogue/catalogue.h"
#include "oracle/exact/systems/elimination.h"

/// The decisions of the chapter as ints, so that all peers answer alike: ours, and plain formulas over any number type.
namespace touchstone::bench {

/// - ours(question...): the decision of robust.
/// - truth(answer): the same int from the oracle's answer.
/// - naive(question...): the formula that one writes inline, without branches where possible; Real: double.
/// - usual(question...): the version in books, if that has early exits.
/// - complete(question...): right if arithmetic is exact; Real: mpq_class. Left out if naive is complete.
template <class Row>
struct Decisions;

template <class Real>
int sign(const Real& x) {
  return (x > 0) - (x < 0);
}

template <class Real>
Real turn(const Point2<Real>& p, const Point2<Real>& q, const Point2<Real>& r) {
  return Real((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}

template <class Real>
bool between(const Real& a, const Real& x, const Real& b) {
  return a < b ? a <= x && x <= b : b <= x && x <= a;
}

template <>
struct Decisions<catalogue::rows::orientation> {
  static constexpr bool decides = true;
  static int ours(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    return 1 - static_cast<int>(robust::orientation(p0, p1, p));
  }
  static int truth(Side side) { return 1 - static_cast<int>(side); }
  template <class Real>
  static int naive(const Point2<Real>& p0, const Point2<Real>& p1, const Point2<Real>& p) {
    return sign(turn(p0, p1, p));
  }
};

template <>
struct Decisions<catalogue::rows::explicit_line> {
  static constexpr bool decides = true;
  static int ours(double slope, double intercept, const Point2d& p) {
    return 1 - static_cast<int>(robust::explicit_line(slope, intercept, p));
  }
  static int truth(Height height) { return 1 - static_cast<int>(height); }
  template <class Real>
  static int naive(const Real& slope, const Real& intercept, const Point2<Real>& p) {
    return sign(Real(p.y - (slope * p.x + intercept)));
  }
};

template <>
struct Decisions<catalogue::rows::implicit_circle> {
  static constexpr bool decides = true;
  static int ours(const Circle2d& circle, const Point2d& p) {
    return 1 - static_cast<int>(robust::implicit_circle(circle, p));
  }
  static int truth(Location location) { return 1 - static_cast<int>(location); }
  template <class Real>
  static int naive(const Circle2<Real>& circle, const Point2<Real>& p) {
    const Vector2<Real> v = p - circle.center;
    return sign(Real(circle.radius * circle.radius - (v.x * v.x + v.y * v.y)));
  }
};

template <>
struct Decisions<catalogue::rows::point_on_segment> {
  static constexpr bool decides = true;
  static int ours(const Point2d& p, const Segment2d& s) {
    return robust::point_on_segment_relation(p, s) == Incidence::on;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation == Incidence::on;
  }
  template <class Real>
  static int naive(const Point2<Real>& p, const Segment2<Real>& s) {
    return turn(s.a, s.b, p) == 0 && between(s.a.x, p.x, s.b.x) && between(s.a.y, p.y, s.b.y);
  }
};

template <>
struct Decisions<catalogue::rows::line_line> {
  static constexpr bool decides = true;
  static int ours(const Line2d& a, const Line2d& b) {
    return robust::line_line_relation(a, b) == LineRelation::crossing;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation == LineRelation::crossing;
  }
  template <class Real>
  static int naive(const Line2<Real>& a, const Line2<Real>& b) {
    return cross(a.q - a.p, b.q - b.p) != 0;
  }
};

template <>
struct Decisions<catalogue::rows::segment_segment> {
  static constexpr bool decides = true;
  static int ours(const Segment2d& a, const Segment2d& b) {
    return robust::segment_segment_relation(a, b) != SegmentRelation::disjoint;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation != SegmentRelation::disjoint;
  }
  /// Four sides. Reports that segments on one line meet.
  template <class Real>
  static int naive(const Segment2<Real>& a, const Segment2<Real>& b) {
    const Real ba = turn(a.a, a.b, b.a), bb = turn(a.a, a.b, b.b), aa = turn(b.a, b.b, a.a), ab = turn(b.a, b.b, a.b);
    return (ba * bb <= 0) & (aa * ab <= 0);
  }
  static int usual(const Segment2d& a, const Segment2d& b) {
    if (turn(a.a, a.b, b.a) * turn(a.a, a.b, b.b) > 0) return false;
    return turn(b.a, b.b, a.a) * turn(b.a, b.b, a.b) <= 0;
  }
  template <class Real>
  static int complete(const Segment2<Real>& a, const Segment2<Real>& b) {
    return oracle::segment_segment_relation<Real>(a, b) != SegmentRelation::disjoint;
  }
};

template <>
struct Decisions<catalogue::rows::ray_segment> {
  static constexpr bool decides = true;
  static int ours(const Ray2d& ray, const Segment2d& s) {
    return robust::ray_segment_relation(ray, s) != RayRelation::none;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation != RayRelation::none;
  }
  /// The ends are on different sides of the ray's line, and that line is met at t >= 0. Reports that a segment on the
  /// ray's line is met.
  template <class Real>
  static int naive(const Ray2<Real>& ray, const Segment2<Real>& s) {
    const Vector2<Real> a = s.a - ray.origin, b = s.b - ray.origin;
    const Real va = cross(ray.direction, a), vb = cross(ray.direction, b);
    return (va * vb <= 0) & (cross(a, b) * (vb - va) >= 0);
  }
  template <class Real>
  static int complete(const Ray2<Real>& ray, const Segment2<Real>& s) {
    const Vector2<Real> a = s.a - ray.origin, b = s.b - ray.origin;
    if (cross(ray.direction, a) != 0 || cross(ray.direction, b) != 0) return naive(ray, s);
    return dot(ray.direction, a) >= 0 || dot(ray.direction, b) >= 0;
  }
};

template <>
struct Decisions<catalogue::rows::point_plane> {
  static constexpr bool decides = true;
  static int ours(const Plane3d& plane, const Point3d& p) {
    return 1 - static_cast<int>(robust::point_plane_side(plane, p));
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return 1 - static_cast<int>(answer.side);
  }
  template <class Real>
  static int naive(const Plane<Real>& plane, const Point3<Real>& p) {
    const Vector3<Real>& n = plane.normal;
    return sign(Real(n.x * p.x + n.y * p.y + n.z * p.z + plane.offset));
  }
};

template <>
struct Decisions<catalogue::rows::point_ground_plane> {
  static constexpr bool decides = true;
  static int ours(const Point3d& p) { return 1 - static_cast<int>(robust::point_ground_plane(p)); }
  template <class Answer>
  static int truth(const Answer& side) {
    return 1 - static_cast<int>(side);
  }
  template <class Real>
  static int naive(const Point3<Real>& p) {
    return sign(p.y);
  }
};

}  // namespace touchstone::bench
