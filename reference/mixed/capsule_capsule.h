// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "reference/mixed/segment_segment_distance.h"

namespace touchstone::reference {

/// Decides whether two capsules, as closed solids, overlap, only touch, or neither. A capsule is the set of points no
/// farther than its radius from its segment.
///
/// No page of the deck asks this. The formula combines two: the nearest points of segment_segment_distance, and p. 44's
/// comparison of a squared distance with the square of the sum of the radii. Equal squares are `touching`.
/// a, b: any unit of length, the same for both. Shapes are closed: where one only reaches the other they are
/// `touching`. A capsule within the other overlaps it, touching it from inside or not.
/// A radius of 0 (or -0) is valid: such a capsule is a segment, which has no interior, and the truth is `touching` at
/// most. A segment of length 0 is valid: the capsule is a ball.
/// NaN or infinity: refused by robust and oracle (field "a.segment[0][0]" ..., "finite number"); so is a negative
/// radius ("a.radius", "b.radius", "radius >= 0").
///
/// The formula assumes that both have interiors: where one has not and they are nearer than the sum of the radii it
/// answers `overlapping`, in exact arithmetic too; and of parallel segments, or one of length 0, it divides by 0, and
/// mostly answers `touching` (cause of both: algorithm). For all others it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53): by the contract of segment_segment_distance each point as computed is,
/// on each axis, within 5u (|p| + |q|) + 2^-1074 of a point of its segment from p to q; let e be the sum of these. So
/// the computed square of the distance is at least (1 - 6u) (D - e)^2 - 2^-1072 where the exact distance D exceeds e.
/// That of the sum R of the radii is at most (1 + 4u) R^2 + 2^-1072. The comparison is exact. So where the first
/// exceeds the second, the double version answers `disjoint`, and is right, unless something overflows or is divided by
/// 0. In the other direction nothing is promised. No number is returned.
template <class Real>
Contact capsule_capsule(const Capsule3<Real>& a, const Capsule3<Real>& b) {
  const auto [x, y] = nearest_of_segments<Real>(a.segment.a, a.segment.b, b.segment.a, b.segment.b);
  const Real distance = dot(x - y, x - y), sum = Real(a.radius + b.radius), reach = Real(sum * sum);
  return distance > reach ? Contact::disjoint : distance < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
