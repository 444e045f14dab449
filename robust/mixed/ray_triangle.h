// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/rays.h"
#include "robust/kernel/filters/ray_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the intersection of a ray and a triangle in space: `none`; `point`, with its t in units of the direction's
/// length, and whether it is `inside` the triangle or on its `boundary`; or `segment`, with the first t and point.
///
/// The origin, edges and corners belong to them. A triangle without area is the segment or the point that its corners
/// span, all of it boundary. Right for all finite doubles in every floating-point environment, and every number
/// correctly rounded (infinite if the exact one is beyond the range). NaN and infinities throw InvalidInput, which
/// names the field and "finite number"; so does a direction of length 0 ("nonzero direction"). Contract:
/// reference/mixed/ray_triangle.h.
RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle);

/// The decision alone, which costs less.
inline SegmentTriangleRelation ray_triangle_relation(const Ray3d& ray, const Triangle3d& triangle);

/// Each stage alone, for tests and other operations; not part of the API.
namespace stages {

struct ray_triangle : Signatures<decltype(robust::ray_triangle)> {
  static Partial enclosed;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::ray_triangle_relation)> {
    /// Decides if the origin is certainly not on the triangle's plane and the ray not parallel to it. If the ray leads
    /// away, there is no intersection. Otherwise its line crosses the plane once, ahead of the origin: inside the
    /// triangle if it has all three edges on one side, outside if it has two of them on different sides.
    static Perhaps<SegmentTriangleRelation> filter(const Ray3d& ray, const Triangle3d& triangle) {
      using filters::Sign;
      const auto& [p, v] = ray;
      const auto& [a, b, c] = triangle;
      const Sign at_origin = filters::FacePlane<double>(a, b, c).side(p), rise = filters::rise(a, b, c, v);
      if (at_origin == Sign::unknown || rise == Sign::unknown) return std::nullopt;
      if (at_origin == rise) return SegmentTriangleRelation::none;
      const Sign ab = filters::rise(p, a, b, v), bc = filters::rise(p, b, c, v), ca = filters::rise(p, c, a, v);
      const auto any = [&](Sign sign) { return ab == sign || bc == sign || ca == sign; };
      if (any(Sign::positive) && any(Sign::negative)) return SegmentTriangleRelation::none;
      if (any(Sign::unknown)) return std::nullopt;
      return SegmentTriangleRelation::point;
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline SegmentTriangleRelation ray_triangle_relation(const Ray3d& ray, const Triangle3d& triangle) {
  return stages::ray_triangle::decision::ask(ray, triangle).answer;
}

}  // namespace touchstone::robust
