// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "geometry/validation.h"
#include "robust/kernel/sphere_filter.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/volumes/sphere_sphere.h. Right for all finite doubles in every floating-point environment.
inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b);
inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b);

/// The same, and which stage decided.
inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b, Stage& decided);
inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. Discs are asked as the balls around them.
inline std::optional<Contact> sphere_sphere_filter(const Sphere3d& a, const Sphere3d& b);
std::optional<Contact> sphere_sphere_lattice(const Sphere3d& a, const Sphere3d& b);
Contact sphere_sphere_exact(const Sphere3d& a, const Sphere3d& b);

/// Validation, then the stages after the filter.
Contact sphere_sphere_past_filter(const Sphere3d& a, const Sphere3d& b, Stage& decided);

/// The ball of which a disc is the section z = 0. Two of them have the contact of the discs: their centers are as far
/// apart, and both or neither have an interior.
inline Sphere3d sphere_sphere_ball(const Circle2d& disc) { return {{disc.center.x, disc.center.y, 0}, disc.radius}; }

/// Of the sign of the radii's sum minus the distance of the centers: a ball of radius 0 has no interior. Looked at as
/// bits, because a subnormal radius may be read as 0.
inline Contact sphere_sphere_for(int reach, const Sphere3d& a, const Sphere3d& b) {
  if (reach < 0) return Contact::disjoint;
  const bool interiors = !validation::zero(a.radius) && !validation::zero(b.radius);
  return reach > 0 && interiors ? Contact::overlapping : Contact::touching;
}

inline filters::Sign sphere_sphere_sign(const Sphere3d& a, const Sphere3d& b) {
  // -0.0, or for validation to refuse
  if (std::signbit(a.radius) || std::signbit(b.radius)) return filters::Sign::unknown;
  return filters::spheres(a, b);
}

inline std::optional<Contact> sphere_sphere_filter(const Sphere3d& a, const Sphere3d& b) {
  const filters::Sign sign = sphere_sphere_sign(a, b);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return sphere_sphere_for(sign == filters::Sign::positive ? 1 : -1, a, b);
}

/// The filter asked directly: g++ keeps an optional in memory.
inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b, Stage& decided) {
  const filters::Sign sign = sphere_sphere_sign(a, b);
  decided = Stage::filter;
  if (sign != filters::Sign::unknown) return sphere_sphere_for(sign == filters::Sign::positive ? 1 : -1, a, b);
  return sphere_sphere_past_filter(a, b, decided);
}
inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b, Stage& decided) {
  return sphere_sphere(sphere_sphere_ball(a), sphere_sphere_ball(b), decided);
}

inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b) {
  Stage ignored;
  return sphere_sphere(a, b, ignored);
}
inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b) {
  Stage ignored;
  return sphere_sphere(a, b, ignored);
}

}  // namespace touchstone::robust
