// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "bench/cgal_peers.h"
#include "bench/plain_peers.h"

/// The peers for rays and segments against triangles, boxes and balls in space. They are formulas for doubles only:
/// even in exact arithmetic they miss cases (a line in the plane of the triangle).
namespace touchstone::bench {

/// Moeller and Trumbore's two coordinates and t, over the determinant, without a division.
struct MoellerTrumbore {
  double determinant, u, v, t;
  MoellerTrumbore(const Point3d& from, const Vector3d& displacement, const Triangle3d& triangle) {
    const Vector3d e = triangle.b - triangle.a, f = triangle.c - triangle.a, p = cross(displacement, f),
                   s = from - triangle.a, q = cross(s, e);
    const double d = dot(e, p), turn = d < 0 ? -1 : 1;
    determinant = turn * d, u = turn * dot(s, p), v = turn * dot(displacement, q), t = turn * dot(f, q);
  }
  bool inside() const { return (determinant > 0) & (u >= 0) & (v >= 0) & (u + v <= determinant) & (t >= 0); }
};

/// The version in books: each test as soon as its number is known, and an epsilon.
inline bool usual_moeller_trumbore(const Point3d& from, const Vector3d& displacement, const Triangle3d& triangle,
                                   double most) {
  const Vector3d e = triangle.b - triangle.a, f = triangle.c - triangle.a, p = cross(displacement, f);
  const double d = dot(e, p);
  if (d > -1e-8 && d < 1e-8) return false;
  const double inverse = 1 / d;
  const Vector3d s = from - triangle.a;
  const double u = dot(s, p) * inverse;
  if (u < 0 || u > 1) return false;
  const Vector3d q = cross(s, e);
  const double v = dot(displacement, q) * inverse;
  if (v < 0 || u + v > 1) return false;
  const double t = dot(f, q) * inverse;
  return t >= 0 && t <= most;
}

struct OfDoubles {
  static constexpr bool decides = true, doubles_alone = true;
};

template <>
struct Decisions<catalogue::rows::ray_triangle> : OfDoubles {
  static int ours(const Ray3d& ray, const Triangle3d& triangle) {
    return robust::ray_triangle_relation(ray, triangle) != SegmentTriangleRelation::none;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation != SegmentTriangleRelation::none;
  }
  static int naive(const Ray3d& ray, const Triangle3d& triangle) {
    return MoellerTrumbore(ray.origin, ray.direction, triangle).inside();
  }
  static int usual(const Ray3d& ray, const Triangle3d& triangle) {
    return usual_moeller_trumbore(ray.origin, ray.direction, triangle, std::numeric_limits<double>::infinity());
  }
};

template <>
struct Decisions<catalogue::rows::segment_triangle> : OfDoubles {
  static int ours(const Segment3d& segment, const Triangle3d& triangle) {
    return robust::segment_triangle_relation(segment, triangle) != SegmentTriangleRelation::none;
  }
  template <class Answer>
  static int truth(const Answer& answer) {
    return answer.relation != SegmentTriangleRelation::none;
  }
  static int naive(const Segment3d& segment, const Triangle3d& triangle) {
    const MoellerTrumbore hit(segment.a, segment.b - segment.a, triangle);
    return hit.inside() & (hit.t <= hit.determinant);
  }
  static int usual(const Segment3d& segment, const Triangle3d& triangle) {
    return usual_moeller_trumbore(segment.a, segment.b - segment.a, triangle, 1);
  }
};

/// Slabs with divisions: 1/0 is infinite, and a NaN from 0/0 is ignored.
struct SlabTest {
  double first, last;
  void cut(double from, double displacement, double min, double max) {
    const double one = (min - from) / displacement, other = (max - from) / displacement;
    first = std::max(first, std::min(one, other)), last = std::min(last, std::max(one, other));
  }
  static int of(const Point3d& p, const Vector3d& v, const Aabb3d& box, double most) {
    SlabTest test{0, most};
    test.cut(p.x, v.x, box.min.x, box.max.x), test.cut(p.y, v.y, box.min.y, box.max.y);
    test.cut(p.z, v.z, box.min.z, box.max.z);
    return test.first <= test.last;
  }
  static int of(const Point2d& p, const Vector2d& v, const Aabb2d& box, double most) {
    SlabTest test{0, most};
    test.cut(p.x, v.x, box.min.x, box.max.x), test.cut(p.y, v.y, box.min.y, box.max.y);
    return test.first <= test.last;
  }
};

template <class Answer>
int hit(const Answer& answer) {
  return answer.relation == PassageRelation::hit;
}

template <>
struct Decisions<catalogue::rows::ray_aabb> : OfDoubles {
  static int ours(const auto& ray, const auto& box) {
    return robust::ray_aabb_relation(ray, box) == PassageRelation::hit;
  }
  static int truth(const auto& answer) { return hit(answer); }
  static int naive(const auto& ray, const auto& box) {
    return SlabTest::of(ray.origin, ray.direction, box, std::numeric_limits<double>::infinity());
  }
};
template <>
struct Decisions<catalogue::rows::segment_aabb> : OfDoubles {
  static int ours(const auto& s, const auto& box) {
    return robust::segment_aabb_relation(s, box) == PassageRelation::hit;
  }
  static int truth(const auto& answer) { return hit(answer); }
  static int naive(const auto& s, const auto& box) { return SlabTest::of(s.a, s.b - s.a, box, 1); }
};

/// f(t) = |c + t v|^2 - r^2: negative at the start, or falling there and with a root.
struct BallTest {
  double start, half, speed;
  BallTest(const auto& c, const auto& v, double radius)
      : start(dot(c, c) - radius * radius), half(dot(c, v)), speed(dot(v, v)) {}
  int passes() const { return (half <= 0) & (half * half >= speed * start); }
};

template <>
struct Decisions<catalogue::rows::ray_sphere> : OfDoubles {
  static int ours(const auto& ray, const auto& ball) {
    return robust::ray_sphere_relation(ray, ball) == PassageRelation::hit;
  }
  static int truth(const auto& answer) { return hit(answer); }
  static int naive(const auto& ray, const auto& ball) {
    const BallTest test(ray.origin - ball.center, ray.direction, ball.radius);
    return (test.start <= 0) | test.passes();
  }
};
template <>
struct Decisions<catalogue::rows::segment_sphere> : OfDoubles {
  static int ours(const auto& s, const auto& ball) {
    return robust::segment_sphere_relation(s, ball) == PassageRelation::hit;
  }
  static int truth(const auto& answer) { return hit(answer); }
  static int naive(const auto& s, const auto& ball) {
    const BallTest test(s.a - ball.center, s.b - s.a, ball.radius);
    const int ends_inside = test.start + 2 * test.half + test.speed <= 0, beyond = test.half + test.speed >= 0;
    return (test.start <= 0) | ends_inside | (test.passes() & beyond);
  }
};

template <class K>
typename K::Point_3 cgal(const Point3d& p) {
  return {p.x, p.y, p.z};
}

/// A ray of CGAL goes through a second point, which Epick rounds: nearly the same question.
template <>
struct CgalPeer<catalogue::rows::ray_triangle> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Ray3d& ray, const Triangle3d& t) {
    const Vector3d& v = ray.direction;
    return std::tuple(typename K::Ray_3(cgal<K>(ray.origin), typename K::Vector_3(v.x, v.y, v.z)),
                      typename K::Triangle_3(cgal<K>(t.a), cgal<K>(t.b), cgal<K>(t.c)));
  }
  template <class Ray, class Triangle>
  static int decide(const Ray& ray, const Triangle& triangle) {
    return CGAL::do_intersect(ray, triangle);
  }
  static bool promised(const Ray3d&, const Triangle3d&) { return false; }
};

template <>
struct CgalPeer<catalogue::rows::segment_triangle> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Segment3d& s, const Triangle3d& t) {
    return std::tuple(typename K::Segment_3(cgal<K>(s.a), cgal<K>(s.b)),
                      typename K::Triangle_3(cgal<K>(t.a), cgal<K>(t.b), cgal<K>(t.c)));
  }
  template <class Segment, class Triangle>
  static int decide(const Segment& segment, const Triangle& triangle) {
    return CGAL::do_intersect(segment, triangle);
  }
  /// It requires triangles with an area and segments with a length.
  static bool promised(const Segment3d& s, const Triangle3d& t) {
    const Vector3d normal = cross(t.b - t.a, t.c - t.a);
    return !(s.a == s.b) && (normal.x != 0 || normal.y != 0 || normal.z != 0);
  }
};

}  // namespace touchstone::bench
