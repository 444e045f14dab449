// SPDX-License-Identifier: Apache-2.0
#pragma once

// CGAL as peer: the same decisions by the library that people use for them, kernels Epick and Epeck.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <tuple>

#include "catalogue/catalogue.h"

namespace touchstone::bench {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

/// shapes(question...)   the question as CGAL's own objects (made before the clock starts)
/// decide(shapes...)     the int of Decisions
/// promised(question...) exact answers can be expected here (CGAL's intersection tests expect proper segments)
///    only_epeck            the question itself takes a construction, which Epick rounds to a different question
template <class Row>
struct CgalPeer;

template <class K>
typename K::Point_2 cgal(const Point2d& p) {
  return {p.x, p.y};
}
template <class K>
typename K::Vector_2 cgal(const Vector2d& v) {
  return {v.x, v.y};
}
template <class K>
typename K::Segment_2 cgal(const Segment2d& s) {
  return {cgal<K>(s.a), cgal<K>(s.b)};
}

template <>
struct CgalPeer<catalogue::rows::orientation> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    return std::tuple(cgal<K>(p0), cgal<K>(p1), cgal<K>(p));
  }
  template <class Point>
  static int decide(const Point& p0, const Point& p1, const Point& p) {
    return static_cast<int>(CGAL::orientation(p0, p1, p));
  }
  static bool promised(const Point2d&, const Point2d&, const Point2d&) { return true; }
};

template <>
struct CgalPeer<catalogue::rows::explicit_line> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(double slope, double intercept, const Point2d& p) {
    return std::tuple(typename K::Line_2(slope, -1, intercept), cgal<K>(p));
  }
  template <class Line, class Point>
  static int decide(const Line& line, const Point& p) {
    return -static_cast<int>(line.oriented_side(p));
  }
  static bool promised(double, double, const Point2d&) { return true; }
};

template <>
struct CgalPeer<catalogue::rows::implicit_circle> {
  static constexpr bool only_epeck = true;  // its circles have only the radius squared
  template <class K>
  static auto shapes(const Circle2d& circle, const Point2d& p) {
    const typename K::FT radius(circle.radius);
    return std::tuple(typename K::Circle_2(cgal<K>(circle.center), radius * radius), cgal<K>(p));
  }
  template <class Circle, class Point>
  static int decide(const Circle& circle, const Point& p) {
    return static_cast<int>(circle.bounded_side(p));
  }
  static bool promised(const Circle2d&, const Point2d&) { return true; }
};

template <>
struct CgalPeer<catalogue::rows::point_on_segment> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Point2d& p, const Segment2d& s) {
    return std::tuple(cgal<K>(p), cgal<K>(s));
  }
  template <class Point, class Segment>
  static int decide(const Point& p, const Segment& s) {
    return s.has_on(p);
  }
  static bool promised(const Point2d&, const Segment2d& s) { return !(s.a == s.b); }
};

template <>
struct CgalPeer<catalogue::rows::line_line> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Line2d& a, const Line2d& b) {
    return std::tuple(cgal<K>(Segment2d{a.p, a.q}), cgal<K>(Segment2d{b.p, b.q}));
  }
  template <class Segment>
  static int decide(const Segment& a, const Segment& b) {
    return !CGAL::parallel(a, b);
  }
  static bool promised(const Line2d&, const Line2d&) { return true; }
};

template <>
struct CgalPeer<catalogue::rows::segment_segment> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Segment2d& a, const Segment2d& b) {
    return std::tuple(cgal<K>(a), cgal<K>(b));
  }
  template <class Segment>
  static int decide(const Segment& a, const Segment& b) {
    return CGAL::do_intersect(a, b);
  }
  static bool promised(const Segment2d& a, const Segment2d& b) { return !(a.a == a.b) && !(b.a == b.b); }
};

template <>
struct CgalPeer<catalogue::rows::ray_segment> {
  static constexpr bool only_epeck = true;  // its ray goes through origin + direction
  template <class K>
  static auto shapes(const Ray2d& ray, const Segment2d& s) {
    return std::tuple(typename K::Ray_2(cgal<K>(ray.origin), cgal<K>(ray.direction)), cgal<K>(s));
  }
  template <class Ray, class Segment>
  static int decide(const Ray& ray, const Segment& s) {
    return CGAL::do_intersect(ray, s);
  }
  /// With coordinates near 2^1011, Epeck of CGAL 5.5.1 says that rays miss segments that CGAL itself finds met over
  /// Gmpq.
  static bool promised(const Ray2d& ray, const Segment2d& s) {
    return !(s.a == s.b) && std::abs(ray.origin.x) < 0x1p1000 && std::abs(ray.direction.x) < 0x1p1000;
  }
};

template <>
struct CgalPeer<catalogue::rows::point_plane> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Plane3d& plane, const Point3d& p) {
    const Vector3d& n = plane.normal;
    return std::tuple(typename K::Plane_3(n.x, n.y, n.z, plane.offset), typename K::Point_3(p.x, p.y, p.z));
  }
  template <class Plane, class Point>
  static int decide(const Plane& plane, const Point& p) {
    return static_cast<int>(plane.oriented_side(p));
  }
  static bool promised(const Plane3d&, const Point3d&) { return true; }
};

template <>
struct CgalPeer<catalogue::rows::point_ground_plane> {
  static constexpr bool only_epeck = false;
  template <class K>
  static auto shapes(const Point3d& p) {
    return std::tuple(typename K::Plane_3(0, 1, 0, 0), typename K::Point_3(p.x, p.y, p.z));
  }
  template <class Plane, class Point>
  static int decide(const Plane& plane, const Point& p) {
    return static_cast<int>(plane.oriented_side(p));
  }
  static bool promised(const Point3d&) { return true; }
};

}  // namespace touchstone::bench
