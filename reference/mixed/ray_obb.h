// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_aabb.h"

namespace touchstone::reference {

/// Narrows by the two planes at right angles to each half axis, through its ends. `from`: from the box's center.
template <class Real>
void cut_along_half_axes(SlabTimes<Real>& times, const Vector3<Real>& from, const Vector3<Real>& displacement,
                         const HalfAxes<Real>& half_axes) {
  for (const Vector3<Real>* a : {&half_axes.u, &half_axes.v, &half_axes.w}) {
    const Real reach = dot(*a, *a);
    times.cut(dot(*a, from), dot(*a, displacement), Real(Real(0) - reach), reach);
  }
}

/// Finds where a ray enters and leaves an oriented box, by the times at which it is between opposite faces, pair by
/// pair.
///
/// No page of the deck asks this. The formula is the textbook's, slabs in the frame of the box (Akenine-Moeller,
/// Haines and Hoffman, Real-Time Rendering, ray/box intersection), with p. 27's half axes a that are not of length 1: d
/// being the displacement from the box's center to the origin, a ray of the direction v is between the two faces that a
/// leads to at the times t with
///     -a . a <= a . d + t (a . v) <= a . a.
/// As in ray_aabb.h, with a . v = 0 that is so all the time or never, and the answer is `hit` from the latest of 0 and
/// the entries to the earliest exit, if that is not before; otherwise `none`.
/// ray, obb: any unit of length, the same for both; t is in units of the direction's length. Closed sets: the origin
/// and the box's boundary belong to them, so a ray that only grazes a face, an edge or a corner is a hit. first is 0 if
/// the origin is in the box. A direction along a face is no special case, and neither is -0. The half axes need not be
/// at right angles: any three independent ones make a solid, a parallelepiped, and the truth is that of this solid.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("ray.origin[0]", "obb.half_axes[0][0]" ...,
/// "finite number"); a direction of length 0 ("ray.direction", "nonzero direction"); half axes that are linearly
/// dependent, one of length zero among them ("obb.half_axes", "linearly independent"). first and last are infinite if
/// the exact ones are beyond the range of doubles.
///
/// In exact arithmetic the formula is right where the half axes are at right angles. Otherwise it takes other planes
/// than those of the faces (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53), unless something overflows. For a half axis a let L = a . a, F = a . v,
/// and P, Q the sums of |a_k d_k| and |a_k v_k|, exactly. Both numerators, as computed, are off by at most e(N) = (5 +
/// 12u) u (P + L) + 2^-1071: four roundings in a . d, three in a . a, one in their difference. F is off by e(F) = (3 +
/// 4u) u Q + 2^-1073. So where |F| > e(F), a time T as computed is off by at most
///     e(T) = (1 + 2u) (e(N) + |T| e(F)) / (|F| - e(F)) + u |T| + 2^-1074,
/// and rounding is monotone, so that an axis's exit stays behind its entry; where Q = 0, the ray is between the two
/// planes or not as the sign of L - |a . d| says, if that is more than e(N). 0 is exact, e(0) = 0. Where one of these
/// holds for each half axis and every entry T, and 0, is more than e(T) + e(S) away from every exit S of another half
/// axis, the relation is that of exact arithmetic, first is off by no more than the greatest e(T) of an entry, and last
/// by no more than that of an exit. ulps: 20 roundings behind first and last (eight, five and five in scalar products,
/// less what is shared; a difference and a quotient).
template <class Real>
Passage<Real> ray_obb(const Ray3<Real>& ray, const Obb3<Real>& obb) {
  SlabTimes<Real> times;
  cut_along_half_axes<Real>(times, ray.origin - obb.center, ray.direction, obb.half_axes);
  return times.passage();
}

}  // namespace touchstone::reference
