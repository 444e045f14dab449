// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The squared distance of the centers against the square of the sum of the radii.
template <class Real, class Solid>
Contact contact_of_squares(const Solid& a, const Solid& b) {
  const auto between = b.center - a.center;
  const Real distance = dot(between, between), reach = Real(a.radius + b.radius), squared_reach = Real(reach * reach);
  return distance > squared_reach   ? Contact::disjoint
         : distance < squared_reach ? Contact::overlapping
                                    : Contact::touching;
}

/// Decides whether two balls, as closed solids, overlap, only touch, or neither. In space; in the plane the same of
/// discs.
///
/// Deck p. 44: two spheres collide if the distance of their centers is not greater than the sum of their radii; so that
/// no root is taken, the squares of both are compared:
///     d . d <= (r + s)^2.
/// The slide says no more. Equal squares are `touching` here.
/// a, b: any unit of length, the same for both. Shapes are closed: balls that have one point of their boundaries in
/// common, from outside, are `touching`. A ball within another overlaps it, touching it from inside or not; so do equal
/// balls.
/// A radius of 0 (or -0) is valid: such a ball is a point, which has no interior, and the truth is `touching` at most.
/// Two equal points touch.
/// NaN or infinity: refused by robust and oracle (field "a.center[0]", "a.radius" ..., "finite number"); so is a
/// negative radius ("a.radius" ..., "radius >= 0").
///
/// The formula assumes that both have an interior. Where a point lies in the interior of the other ball it answers
/// `overlapping`, in exact arithmetic too (cause: algorithm). For all other balls it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53): let S be the exact squared distance of the centers and R the exact
/// square of the sum of the radii. Each square in S carries its difference's rounding twice and its own, and goes
/// through two sums at most: off by at most ((1 + u)^5 - 1) S <= (5 + 11u) u S, and where squares underflow by 3 (1 +
/// u)^2 2^-1075. R has one rounding less of each sort: off by at most ((1 + u)^3 - 1) R <= (3 + 4u) u R and 2^-1075.
/// The comparison is exact. So where |S - R| > (5 + 11u) u S + (3 + 4u) u R + 2^-1072, unless S or R overflows, the
/// double version answers as exact arithmetic does. No number is returned.
template <class Real>
Contact sphere_sphere(const Circle2<Real>& a, const Circle2<Real>& b) {
  return contact_of_squares<Real>(a, b);
}
template <class Real>
Contact sphere_sphere(const Sphere3<Real>& a, const Sphere3<Real>& b) {
  return contact_of_squares<Real>(a, b);
}

}  // namespace touchstone::reference
