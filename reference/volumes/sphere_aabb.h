// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "reference/volumes/closest_point_on_aabb.h"

namespace touchstone::reference {

/// The squared distance of the center from the nearest point of the box against the square of the radius.
template <class Real, class Ball, class Box>
Contact contact_of_nearest_point(const Ball& sphere, const Box& aabb) {
  const auto displacement = closest_point_on_aabb(sphere.center, aabb) - sphere.center;
  const Real distance = dot(displacement, displacement), squared_radius = Real(sphere.radius * sphere.radius);
  return distance > squared_radius   ? Contact::disjoint
         : distance < squared_radius ? Contact::overlapping
                                     : Contact::touching;
}

/// Decides whether a ball and an axis-aligned box, as closed solids, overlap, only touch, or neither. In space; in the
/// plane the same of a disc and a rectangle.
///
/// Deck p. 48-50: the point of the box that is nearest to the center is found by moving each coordinate of the center
/// into the interval of the box; they collide if it is not farther from the center than the radius. So that no root is
/// taken, squares are compared: with q that nearest point
///     (c - q) . (c - q) <= r^2.
/// The slide says no more. Equal squares are `touching` here.
/// sphere, aabb: any unit of length, the same for both. Shapes are closed: where the ball only reaches a face, an edge
/// or a corner they are `touching`. A ball within the box overlaps it, touching a face from inside or not; so does a
/// box within the ball; where both have an interior.
/// A radius of 0 (or -0) is valid: such a ball is a point. min == max on an axis is valid: a flat box. Neither has an
/// interior, and the truth is `touching` at most.
/// NaN or infinity: refused by robust and oracle (field "sphere.center[0]", "aabb.min[0]" ..., "finite number"); so are
/// a negative radius ("sphere.radius", "radius >= 0") and min > max ("aabb.max[0]" ..., "min <= max").
///
/// The formula assumes that the box has an interior. Where a flat box comes nearer to the center than the radius it
/// answers `overlapping`, in exact arithmetic too (cause: algorithm). For all other boxes it is right in exact
/// arithmetic: a point has no distance below its radius, 0.
///
/// Rounding (binary64, to nearest, u = 2^-53): let S be the exact squared distance of the center from the box and R the
/// exact square of the radius. The nearest point is exact. Each square in S carries its difference's rounding twice and
/// its own, and goes through two sums at most: off by at most ((1 + u)^5 - 1) S <= (5 + 11u) u S, and where squares
/// underflow by 3 (1 + u)^2 2^-1075. R is off by at most u R and 2^-1075. The comparison is exact. So where |S - R| >
/// (5 + 11u) u S + u R + 2^-1072, unless S or R overflows, the double version answers as exact arithmetic does. No
/// number is returned.
template <class Real>
Contact sphere_aabb(const Circle2<Real>& sphere, const Aabb2<Real>& aabb) {
  return contact_of_nearest_point<Real>(sphere, aabb);
}
template <class Real>
Contact sphere_aabb(const Sphere3<Real>& sphere, const Aabb3<Real>& aabb) {
  return contact_of_nearest_point<Real>(sphere, aabb);
}

}  // namespace touchstone::reference
