// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/volumes.h"
#include "reference/mixed/closest_point_on_segment.h"

namespace touchstone::reference {

/// Decides whether a ball and a capsule, as closed solids, overlap, only touch, or neither. A capsule is the set of
/// points no farther than its radius from its segment.
///
/// No page of the deck asks this. The formula combines two: the nearest point of closest_point_on_segment, and p. 44's
/// comparison of a squared distance with the square of the sum of the radii. Equal squares are `touching`.
/// sphere, capsule: any unit of length, the same for both. Shapes are closed: where one only reaches the other they are
/// `touching`. A ball within the capsule overlaps it, touching it from inside or not.
/// A radius of 0 (or -0) is valid: such a ball is a point, such a capsule a segment. Neither has an interior, and the
/// truth is `touching` at most. A segment of length 0 is valid: the capsule is a ball.
/// NaN or infinity: refused by robust and oracle (field "sphere.center[0]", "capsule.segment[0][0]" ..., "finite
/// number"); so is a negative radius ("sphere.radius", "capsule.radius", "radius >= 0").
///
/// The formula assumes that both have interiors: where one has not and they are nearer than the sum of the radii it
/// answers `overlapping`, in exact arithmetic too; and of a segment of length 0 it divides 0 by 0, by which it answers
/// `touching` (cause of both: algorithm). For all others it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53): by the contract of closest_point_on_segment the computed square of the
/// distance is off by E = 2 D e + e^2 + 6u (D + e)^2 + 2^-1072, D being the exact distance. That of the sum R of the
/// radii is off by (3 + 4u) u R^2 and 2^-1075. The comparison is exact. So where |D^2 - R^2| > E + (3 + 4u) u R^2 +
/// 2^-1072, and that contract promises anything, the double version answers as exact arithmetic does, unless something
/// overflows. No number is returned.
template <class Real>
Contact sphere_capsule(const Sphere3<Real>& sphere, const Capsule3<Real>& capsule) {
  const Vector3<Real> displacement =
      nearest_between<Real>(sphere.center, capsule.segment.a, capsule.segment.b) - sphere.center;
  const Real distance = dot(displacement, displacement), sum = Real(sphere.radius + capsule.radius),
             reach = Real(sum * sum);
  return distance > reach ? Contact::disjoint : distance < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
