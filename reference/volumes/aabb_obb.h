// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/volumes/obb_obb.h"

namespace touchstone::reference {

/// The box as one of center and half axes.
template <class Real>
Obb3<Real> as_obb(const Aabb3<Real>& box) {
  const Vector3<Real> half = Real(Real(1) / Real(2)) * (box.max - box.min);
  return {box.min + half, {{half.x, Real(0), Real(0)}, {Real(0), half.y, Real(0)}, {Real(0), Real(0), half.z}}};
}

/// Decides whether an axis-aligned box and an oriented box, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is obb_obb's (p. 27), the first box being given by center and half axes,
/// as three.js has it (OBB.intersectsBox3).
/// aabb, obb: any unit of length, the same for both. Each solid is closed. Common corners, edges and faces are
/// `touching`, and so are two edges that cross. A box within another overlaps it.
/// min == max on an axis is valid: such a box is flat and has no interior, and the truth is `touching` at most: also
/// where the box lies deep in the other. The half axes need not be at right angles: the oriented box is the
/// parallelepiped that they span, exactly, and has an interior.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("aabb.min[0]", "obb.half_axes[0][0]" ...,
/// "finite number"); min > max ("aabb.max[0]" ..., "min <= max"); half axes that are linearly dependent, one of length
/// zero among them ("obb.half_axes", "linearly independent").
///
/// In exact arithmetic the formula is right where obb_obb's is, of boxes that are not flat. On a flat box one of its
/// axes is zero, as of parallel edges: it answers `touching` at least, though the others do not tell on which side of
/// the flat box all of the other is (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): the double version answers as obb_obb's does of the box that the
/// computed center and half axes make. A half axis is off by u of itself and 2^-1075, the center by that and u of
/// itself: so each face of that box is off by at most 3u (|min| + |max|) + 2^-1074 on its axis, unless something
/// overflows. No number is returned.
template <class Real>
Contact aabb_obb(const Aabb3<Real>& aabb, const Obb3<Real>& obb) {
  return obb_obb(as_obb(aabb), obb);
}

}  // namespace touchstone::reference
