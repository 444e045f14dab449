// SPDX-License-Identifier: Apache-2.0
// The formulas that are found in most ray tracers, over plain doubles, as peers.

#include <touchstone/geometry/rays.h>
#include <touchstone/program/engine_main.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace touchstone;

/// Moeller and Trumbore with the usual epsilon, slabs with inverses, and the quadratic.
struct RayFormulas {
  static constexpr const char* name = "Moeller-Trumbore with 1e-8, slabs with inverses, the quadratic";
  static constexpr auto boundary = Boundary::closed;

  RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle) {
    const auto t = first(ray, triangle);
    if (!t) return {SegmentTriangleRelation::none, {}, {}, {}};
    return {SegmentTriangleRelation::point, *t, ray.origin + *t * ray.direction, {}};
  }
  bool segment_triangle(const Segment3d& s, const Triangle3d& triangle) {
    const auto t = first({s.a, s.b - s.a}, triangle);
    return t && *t <= 1;
  }

  Passage<double> ray_aabb(const Ray3d& ray, const Aabb3d& box) {
    return slabs(ray.origin, ray.direction, box, std::numeric_limits<double>::infinity());
  }
  Passage<double> segment_aabb(const Segment3d& s, const Aabb3d& box) { return slabs(s.a, s.b - s.a, box, 1); }

  Passage<double> ray_sphere(const Ray3d& ray, const Sphere3d& ball) {
    return roots(ray.origin, ray.direction, ball, std::numeric_limits<double>::infinity());
  }
  Passage<double> segment_sphere(const Segment3d& s, const Sphere3d& ball) { return roots(s.a, s.b - s.a, ball, 1); }

 private:
  static std::optional<double> first(const Ray3d& ray, const Triangle3d& triangle) {
    const Vector3d e = triangle.b - triangle.a, f = triangle.c - triangle.a, p = cross(ray.direction, f);
    const double d = dot(e, p);
    if (std::abs(d) < 1e-8) return std::nullopt;
    const double inverse = 1 / d;
    const Vector3d s = ray.origin - triangle.a, q = cross(s, e);
    const double u = dot(s, p) * inverse, v = dot(ray.direction, q) * inverse, t = dot(f, q) * inverse;
    if (u < 0 || u > 1 || v < 0 || u + v > 1 || t < 0) return std::nullopt;
    return t;
  }

  static Passage<double> slabs(const Point3d& p, const Vector3d& v, const Aabb3d& box, double most) {
    double first = 0, last = most;
    const auto cut = [&](double from, double inverse, double min, double max) {
      const double one = (min - from) * inverse, other = (max - from) * inverse;
      first = std::max(first, std::min(one, other)), last = std::min(last, std::max(one, other));
    };
    cut(p.x, 1 / v.x, box.min.x, box.max.x), cut(p.y, 1 / v.y, box.min.y, box.max.y);
    cut(p.z, 1 / v.z, box.min.z, box.max.z);
    if (!(first <= last)) return {PassageRelation::none, {}, {}};
    return {PassageRelation::hit, first, last};
  }

  static Passage<double> roots(const Point3d& p, const Vector3d& v, const Sphere3d& ball, double most) {
    const Vector3d c = p - ball.center;
    const double a = dot(v, v), b = 2 * dot(c, v), rest = b * b - 4 * a * (dot(c, c) - ball.radius * ball.radius);
    if (rest < 0) return {PassageRelation::none, {}, {}};
    const double root = std::sqrt(rest), one = (-b - root) / (2 * a), other = (-b + root) / (2 * a);
    if (other < 0 || one > most) return {PassageRelation::none, {}, {}};
    return {PassageRelation::hit, std::max(one, 0.0), std::min(other, most)};
  }
};

TOUCHSTONE_ENGINE_MAIN(RayFormulas)
