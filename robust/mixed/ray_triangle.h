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

namespace stages {

struct ray_triangle : Signatures<decltype(robust::ray_triangle)> {
  static Partial enclosed;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::ray_triangle_relation)> {
    /// Decides if the ray is certainly not parallel to the triangle's plane. Its line crosses the plane once; if that
    /// is certainly behind the origin, or beyond an edge, there is no intersection. One branch: the answer is
    /// unpredictable.
    static Perhaps<SegmentTriangleRelation> filter(const Ray3d& ray, const Triangle3d& triangle) {
      using filters::Sign;
      const filters::RayAndTriangle<double> both(ray.origin, ray.direction, triangle.a, triangle.b, triangle.c);
      const Sign rise = both.rise(), other = rise == Sign::positive ? Sign::negative : Sign::positive;
      const Sign t = both.height(), ab = both.beside_ab(), bc = both.beside_bc(), ca = both.beside_ca();
      const int certain = rise != Sign::unknown;
      const int misses = (t == other) | (ab == other) | (bc == other) | (ca == other);
      const int meets = (t == rise) & (ab == rise) & (bc == rise) & (ca == rise);
      if ((certain & (misses | meets)) == 0) [[unlikely]]
        return std::nullopt;
      return misses != 0 ? SegmentTriangleRelation::none : SegmentTriangleRelation::point;
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
