// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/thin_shapes.h"
#include "geometry/validation.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/sphere_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two balls, as closed solids, are `disjoint`, only touch or overlap; in the plane the same for discs.
///
/// `touching`: they have one point of their boundaries in common, from outside; a ball within another overlaps it. A
/// ball of radius 0 is a point, which has no interior and can only touch. Right for all finite doubles in every
/// floating-point environment. NaN and infinities throw InvalidInput, which names the field and "finite number"; so
/// does a negative radius ("radius >= 0"). Contract: reference/volumes/sphere_sphere.h.
inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b);
inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b);

namespace stages {

struct sphere_sphere : Filtered<sphere_sphere> {
  /// A ball, or the ball whose section z = 0 is a disc. Two of these have the contact of the discs: their centers are
  /// equally far apart, and both or neither have an interior.
  struct Ball : Sphere3d {
    Ball(const Sphere3d& ball) : Sphere3d(ball) {}
    Ball(const Circle2d& disc) : Sphere3d{{disc.center.x, disc.center.y, 0}, disc.radius} {}
  };

  static Perhaps<Contact> filter(const Ball& a, const Ball& b) {
    // -0.0, or negative, which validation refuses
    if (kernel::sign_bit(a.radius) || kernel::sign_bit(b.radius)) return std::nullopt;
    return filters::by_sign(filters::spheres<double>(a, b), contact(1, a, b), Contact::disjoint);
  }
  static Perhaps<Contact> lattice(const Ball& a, const Ball& b);
  static Contact exact(const Ball& a, const Ball& b);
  static Decided<Contact> past_filter(const Ball& a, const Ball& b);

  /// The contact from the sign of the radii's sum minus the distance of the centers: a ball of radius 0 has no
  /// interior. Tests bits, because a subnormal radius may be read as 0.
  static Contact contact(int reach, const Ball& a, const Ball& b) {
    if (reach < 0) return Contact::disjoint;
    const bool interiors = !validation::zero(a.radius) && !validation::zero(b.radius);
    return reach > 0 && interiors ? Contact::overlapping : Contact::touching;
  }
};

}  // namespace stages

inline Contact sphere_sphere(const Circle2d& a, const Circle2d& b) { return stages::sphere_sphere::ask(a, b).answer; }
inline Contact sphere_sphere(const Sphere3d& a, const Sphere3d& b) { return stages::sphere_sphere::ask(a, b).answer; }

}  // namespace touchstone::robust
