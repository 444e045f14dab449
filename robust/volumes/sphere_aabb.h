// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/sphere_box_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and an axis-aligned box, as closed solids, are `disjoint`, only touch or overlap; in the
/// plane the same for a disc and a rectangle.
///
/// `touching`: they have a common point and no common interior point: a point of the box is as far from the center as
/// the radius is long and none is nearer; or they meet, and one of them has no interior, because the radius is 0 or min
/// == max on an axis. If both have one, a ball within the box overlaps it, and a box within the ball. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do a negative radius ("radius >= 0") and min > max ("min <= max"). Contract:
/// reference/volumes/sphere_aabb.h.
inline Contact sphere_aabb(const Circle2d& sphere, const Aabb2d& aabb);
inline Contact sphere_aabb(const Sphere3d& sphere, const Aabb3d& aabb);

namespace stages {

/// The filter decides boxes that have an interior and a distance that differs from the radius.
struct sphere_aabb : Filtered<sphere_aabb> {
  static filters::Sign sign(const Circle2d& s, const Aabb2d& b) {
    using filters::beyond_interval;
    return filters::ball_and_box<double>(s.radius, beyond_interval(s.center.x, b.min.x, b.max.x),
                                         beyond_interval(s.center.y, b.min.y, b.max.y));
  }
  static filters::Sign sign(const Sphere3d& s, const Aabb3d& b) {
    using filters::beyond_interval;
    return filters::ball_and_box<double>(s.radius, beyond_interval(s.center.x, b.min.x, b.max.x),
                                         beyond_interval(s.center.y, b.min.y, b.max.y),
                                         beyond_interval(s.center.z, b.min.z, b.max.z));
  }
  template <class Ball, class Box>
  static Perhaps<Contact> filter(const Ball& sphere, const Box& aabb) {
    if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
    // A square that is certainly greater than another is not 0: the ball has an interior, too.
    return filters::by_sign(sign(sphere, aabb), Contact::overlapping, Contact::disjoint);
  }
  template <class Ball, class Box>
  static Perhaps<Contact> lattice(const Ball& sphere, const Box& aabb);
  template <class Ball, class Box>
  static Contact exact(const Ball& sphere, const Box& aabb);
  template <class Ball, class Box>
  static Decided<Contact> past_filter(const Ball& sphere, const Box& aabb);
};

}  // namespace stages

inline Contact sphere_aabb(const Circle2d& sphere, const Aabb2d& aabb) {
  return stages::sphere_aabb::ask(sphere, aabb).answer;
}
inline Contact sphere_aabb(const Sphere3d& sphere, const Aabb3d& aabb) {
  return stages::sphere_aabb::ask(sphere, aabb).answer;
}

}  // namespace touchstone::robust
