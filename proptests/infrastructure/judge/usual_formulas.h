// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/capsules.h"
#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/rays.h"
#include "geometry/volumes.h"

/// What programs of games compute, in doubles: formulas that are right but for rounding. Where one has no answer by its
/// documentation, it throws InvalidInput.
namespace touchstone::proptests::usual {

/// How a bound is compared: as closed sets do, or, a bug, as open sets do.
enum class Bound { closed, open };
inline bool beyond(double x, double bound, Bound how) { return how == Bound::open ? x >= bound : x > bound; }

inline double clamped(double t) { return std::clamp(t, 0.0, 1.0); }

struct Barycentric {
  double t, u, v;
  bool inside() const { return u > 0 && v > 0 && u + v < 1; }
};
/// Moeller and Trumbore.
inline std::optional<Barycentric> barycentric(const Point3d& o, const Vector3d& d, const Triangle3d& triangle,
                                              Bound how) {
  const Vector3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, h = cross(d, e2);
  const double a = dot(e1, h);
  if (a == 0) throw InvalidInput("triangle", "no line in its plane");
  const double f = 1 / a;
  const Vector3d s = o - triangle.a, q = cross(s, e1);
  const double u = f * dot(s, h), v = f * dot(d, q);
  if (beyond(-u, 0, how) || beyond(u, 1, how) || beyond(-v, 0, how) || beyond(u + v, 1, how)) return std::nullopt;
  return Barycentric{f * dot(e2, q), u, v};
}
inline RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle, Bound how = Bound::closed) {
  const auto hit = barycentric(ray.origin, ray.direction, triangle, how);
  if (!hit || !(hit->t >= 0)) return {SegmentTriangleRelation::none, {}, {}, {}};
  return {SegmentTriangleRelation::point, hit->t, ray.origin + hit->t * ray.direction,
          hit->inside() ? Location::inside : Location::boundary};
}
inline SegmentTriangle<double> segment_triangle(const Segment3d& segment, const Triangle3d& triangle,
                                                Bound how = Bound::closed) {
  const Vector3d d = segment.b - segment.a;
  const auto hit = barycentric(segment.a, d, triangle, how);
  if (!hit || !(hit->t >= 0 && hit->t <= 1)) return {SegmentTriangleRelation::none, {}, {}, {}};
  return {SegmentTriangleRelation::point, hit->t, segment.a + hit->t * d, {}};
}

/// Ericson's closest points of two segments. `clamps`: the second parameter is moved into [0, 1].
template <class Point>
std::pair<Point, Point> closest(const Point& p1, const Point& q1, const Point& p2, const Point& q2, bool clamps) {
  const auto d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r);
  double s = 0, t = 0;
  if (a == 0 && e > 0) {
    t = clamped(f / e);
  } else if (a > 0 && e == 0) {
    s = clamped(-c / a);
  } else if (a > 0) {
    const double b = dot(d1, d2), denominator = a * e - b * b;
    s = denominator != 0 ? clamped((b * f - c * e) / denominator) : 0;
    t = b * s + f;
    if (clamps && t < 0) t = 0, s = clamped(-c / a);
    else if (clamps && t > e) t = 1, s = clamped((b - c) / a);
    else t /= e;
  }
  return {p1 + s * d1, p2 + t * d2};
}
template <class Pair, class Segment>
Pair closest_pair(const Segment& a, const Segment& b, bool clamps = true) {
  const auto [x, y] = closest(a.a, a.b, b.a, b.b, clamps);
  const double square = dot(x - y, x - y);
  return {x, y, square, std::sqrt(square)};
}

inline bool within(double squared_distance, double reach, Bound how) {
  const double square = reach * reach;
  return how == Bound::open ? squared_distance < square : squared_distance <= square;
}
inline bool capsule_capsule(const Capsule3d& a, const Capsule3d& b, Bound how = Bound::closed) {
  const auto [x, y] = closest(a.segment.a, a.segment.b, b.segment.a, b.segment.b, true);
  return within(dot(x - y, x - y), a.radius + b.radius, how);
}
inline bool sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule, Bound how = Bound::closed) {
  const auto& [a, b] = capsule.segment;
  const Vector3d ab = b - a, ac = sphere.center - a, bc = sphere.center - b;
  const double e = dot(ac, ab), f = dot(ab, ab);
  const double square = e <= 0 ? dot(ac, ac) : e >= f ? dot(bc, bc) : dot(ac, ac) - e * e / f;
  return within(square, sphere.radius + capsule.radius, how);
}

/// Ericson's closest point of a triangle.
inline Point3d closest_on_triangle(const Point3d& p, const Triangle3d& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3d ab = b - a, ac = c - a, ap = p - a, normal = cross(ab, ac);
  if (dot(normal, normal) == 0) throw InvalidInput("triangle", "an area");
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = dot(ab, p - b), d4 = dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const double d5 = dot(ab, p - c), d6 = dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double denominator = 1 / (va + vb + vc);
  return a + vb * denominator * ab + vc * denominator * ac;
}
inline ClosestPoint3<double> closest_point_on_triangle(const Point3d& p, const Triangle3d& triangle) {
  const Point3d x = closest_on_triangle(p, triangle);
  const double square = dot(p - x, p - x);
  return {x, square, std::sqrt(square)};
}
inline bool sphere_triangle(const Sphere3d& sphere, const Triangle3d& triangle, Bound how = Bound::closed) {
  const Vector3d displacement = closest_on_triangle(sphere.center, triangle) - sphere.center;
  return within(dot(displacement, displacement), sphere.radius, how);
}

/// Slabs with the reciprocal of the direction. `how`: of the times, and of a direction that is 0 on an axis.
class Slabs {
 public:
  explicit Slabs(double last, Bound how) : last_(last), how_(how) {}
  void cut(double o, double d, double min, double max) {
    if (d == 0) {
      meets_ = meets_ && !beyond(o, max, how_) && !beyond(min, o, how_);
      return;
    }
    const double reciprocal = 1 / d, at_min = (min - o) * reciprocal, at_max = (max - o) * reciprocal;
    first_ = std::max(first_, std::min(at_min, at_max)), last_ = std::min(last_, std::max(at_min, at_max));
  }
  Passage<double> passage() const {
    if (!meets_ || beyond(first_, last_, how_)) return {PassageRelation::none, {}, {}};
    return {PassageRelation::hit, first_, last_};
  }

 private:
  double first_ = 0, last_;
  Bound how_;
  bool meets_ = true;
};
inline Passage<double> through(Slabs slabs, const Point2<double>& o, const Vector2<double>& d, const Aabb2d& box) {
  slabs.cut(o.x, d.x, box.min.x, box.max.x), slabs.cut(o.y, d.y, box.min.y, box.max.y);
  return slabs.passage();
}
inline Passage<double> through(Slabs slabs, const Point3d& o, const Vector3d& d, const Aabb3d& box) {
  slabs.cut(o.x, d.x, box.min.x, box.max.x), slabs.cut(o.y, d.y, box.min.y, box.max.y);
  slabs.cut(o.z, d.z, box.min.z, box.max.z);
  return slabs.passage();
}

/// Gottschalk's separating axes in the frame of the first box. `edges`: the nine of two edges are tried, too.
inline bool obb_obb(const Obb3d& a, const Obb3d& b, Bound how = Bound::closed, bool edges = true) {
  const std::array<Vector3d, 3> of_a{a.half_axes.u, a.half_axes.v, a.half_axes.w},
      of_b{b.half_axes.u, b.half_axes.v, b.half_axes.w};
  std::array<double, 3> ea, eb, t;
  std::array<Vector3d, 3> ua, ub;
  for (std::size_t i = 0; i < 3; ++i) {
    ea[i] = std::sqrt(dot(of_a[i], of_a[i])), eb[i] = std::sqrt(dot(of_b[i], of_b[i]));
    ua[i] = 1 / ea[i] * of_a[i], ub[i] = 1 / eb[i] * of_b[i];
  }
  double r[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = dot(b.center - a.center, ua[i]);
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = dot(ua[i], ub[j]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    double reach_b = 0, reach_a = 0, along = 0;
    for (std::size_t j = 0; j < 3; ++j)
      reach_b += eb[j] * std::fabs(r[i][j]), reach_a += ea[j] * std::fabs(r[j][i]), along += t[j] * r[j][i];
    if (beyond(std::fabs(t[i]), ea[i] + reach_b, how) || beyond(std::fabs(along), reach_a + eb[i], how)) return false;
  }
  for (std::size_t i = 0; edges && i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double reach = ea[i1] * std::fabs(r[i2][j]) + ea[i2] * std::fabs(r[i1][j]) + eb[j1] * std::fabs(r[i][j2]) +
                           eb[j2] * std::fabs(r[i][j1]);
      if (std::fabs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) > reach) return false;  // both 0 for parallel edges
    }
  }
  return true;
}
inline bool point_in_obb(const Obb3d& obb, const Point3d& point, Bound how = Bound::closed) {
  for (const Vector3d& axis : {obb.half_axes.u, obb.half_axes.v, obb.half_axes.w}) {
    const double length = std::sqrt(dot(axis, axis));
    if (beyond(std::fabs(dot(point - obb.center, 1 / length * axis)), length, how)) return false;
  }
  return true;
}

/// Akenine-Moeller's separating axes. `edges`: the nine of an edge and an axis are tried, too.
inline bool triangle_aabb(const Triangle3d& triangle, const Aabb3d& box, bool edges = true) {
  const Point3d center{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, (box.min.z + box.max.z) / 2};
  const Vector3d h{(box.max.x - box.min.x) / 2, (box.max.y - box.min.y) / 2, (box.max.z - box.min.z) / 2};
  const Vector3d v[]{triangle.a - center, triangle.b - center, triangle.c - center};
  const auto separates = [&](const Vector3d& n) {
    const double first = dot(n, v[0]), second = dot(n, v[1]), third = dot(n, v[2]);
    double least = second < first ? second : first, most = second < first ? first : second;
    if (third < least) least = third;
    else if (!(third < most)) most = third;
    const double reach = std::fabs(n.x) * h.x + std::fabs(n.y) * h.y + std::fabs(n.z) * h.z;
    return least > reach || most < -reach;
  };
  for (const Vector3d& axis : {Vector3d{1, 0, 0}, Vector3d{0, 1, 0}, Vector3d{0, 0, 1}}) {
    if (separates(axis)) return false;
    for (std::size_t i = 0; edges && i < 3; ++i)
      if (separates(cross(axis, v[(i + 1) % 3] - v[i]))) return false;
  }
  return !separates(cross(v[1] - v[0], v[2] - v[1]));
}

}  // namespace touchstone::proptests::usual
