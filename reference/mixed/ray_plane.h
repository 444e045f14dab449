// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"

namespace touchstone::reference {

/// Finds the intersection of a ray in space and a plane.
///
/// No page of the deck asks this. The formula combines two: p. 22's E(p) = N . p + d and p. 9's point origin + t
/// direction, with E0 = E(origin) and the rise R = N . direction:
///     E(origin + t direction) = E0 + t R,  t = -E0 / R;
/// `point` at origin + t direction where 0 <= t, otherwise (also where R = 0) `none`.
/// The plane is the thin set N . p + d = 0 and has no solid side: a ray crosses it from either side. ray, plane:
/// origin, direction and d / |N| in any unit of length, the same for both; N of any length but 0. t is in units of the
/// direction's length. Closed sets: an origin on the plane is a `point` with t = 0, wherever the ray leads, unless it
/// leads along the plane. `inside`: all of the ray lies in the plane, so there is no single t. A ray parallel to the
/// plane and off it is `none`. NaN or infinity: refused by robust and oracle (field, "finite number"); so are a
/// direction of length 0 ("ray.direction", "nonzero direction") and N = 0 ("plane.normal", "nonzero normal"). t and the
/// point are infinite if the exact ones are beyond the range of doubles.
///
/// In exact arithmetic the formula is right, except where E0 = R = 0: there it answers `none` instead of `inside`
/// (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): with e(E) the bound of point_plane.h, for R with 0 instead of d, it is
/// right where E0 and R each exceed their bounds and |E0| > 2^-1074 |R| (else t may round to 0). Where it is rightly
/// `point`, t, of which T is the computed one, is off by at most
///     e(t) = (e(E0) + (T + 2u T + 2^-1074) e(R)) / (|R| - e(R)) + 2u T + 2^-1074:
/// the exact quotient of E0 and R as computed is within 2u T + 2^-1074 of T. A coordinate X of the point, with V of the
/// direction, is off by at most |V| e(t) + 2u (|T V| + |X|) + 2^-1074, unless something overflows.
/// ulps: 14 roundings behind the point (six in E0, five in R, quotient, product, sum).
template <class Real>
LinePlane<Real> ray_plane(const Ray3<Real>& ray, const Plane<Real>& plane) {
  const auto& [origin, direction] = ray;
  const Real e0 = dot(plane.normal, Vector3<Real>{origin.x, origin.y, origin.z}) + plane.offset;
  const Real rise = dot(plane.normal, direction);
  if (rise == Real(0)) return {LinePlaneRelation::none, std::nullopt, std::nullopt};
  const Real t = Real(Real(-e0) / rise);
  if (Real(0) <= t) return {LinePlaneRelation::point, t, origin + t * direction};
  return {LinePlaneRelation::none, std::nullopt, std::nullopt};
}

}  // namespace touchstone::reference
