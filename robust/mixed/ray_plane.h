// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/rays.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the intersection of a ray in space and the thin plane normal . p + offset = 0: `none`; `point`, with its t in
/// units of the direction's length, from either side; or `inside`, all of the ray.
///
/// An origin on the plane is a `point` at t = 0, unless the ray leads along the plane. Right for all finite doubles in
/// every floating-point environment, and every number correctly rounded (infinite if the exact one is beyond the
/// range). NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a direction of
/// length 0 ("nonzero direction") and a normal of length 0 ("nonzero normal"). Contract: reference/mixed/ray_plane.h.
LinePlane<double> ray_plane(const Ray3d& ray, const Plane3d& plane);

/// The decision alone, which costs less.
inline LinePlaneRelation ray_plane_relation(const Ray3d& ray, const Plane3d& plane);

namespace stages {

struct ray_plane : Signatures<decltype(robust::ray_plane)> {
  static Partial enclosed;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::ray_plane_relation)> {
    /// Decides if the origin is not on the plane and the ray not parallel to it. The rise N . direction is the height
    /// of the point `direction` over the parallel plane through 0.
    static Perhaps<LinePlaneRelation> filter(const Ray3d& ray, const Plane3d& plane) {
      const auto& [x, y, z] = ray.direction;
      const filters::Sign height = filters::plane(plane, ray.origin),
                          rise = filters::plane(Plane3d{plane.normal, 0.0}, Point3d{x, y, z});
      if (height == filters::Sign::unknown || rise == filters::Sign::unknown) return std::nullopt;
      return height == rise ? LinePlaneRelation::none : LinePlaneRelation::point;
    }
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline LinePlaneRelation ray_plane_relation(const Ray3d& ray, const Plane3d& plane) {
  return stages::ray_plane::decision::ask(ray, plane).answer;
}

}  // namespace touchstone::robust
