// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/window.h"
#include "robust/kernel/filters/staged.h"

/// Enclosed crossings of lines with the plane of a triangle.
namespace touchstone::robust::kernel {

struct PlaneCrossing {
  double t;
  Point3d point;
};

/// Checks that a number is 0, or of a magnitude in [2^-80, 2^40], as rounding leaves coordinates that should be 0: a
/// multiple of 2^-132.
///
/// Polynomials of degree 3 are then 0, or between 2^-396 and 2^125, and multiples of 2^-396, with all their tails. A
/// quotient of two lies between 2^-521 and 2^521, its head is a multiple of 2^-547, and what is left, n - q d, one of
/// 2^-943: nothing underflows but that times the inverse, as in window.h.
inline bool crossable(double x) {
  const double size = filters::FloatFormat<double>::magnitude(x);
  return ((size >= 0x1p-80) & (size <= 0x1p40)) | validation::zero(x);
}
template <class... Vectors>
bool crossable(const Vectors&... v) {
  return ((crossable(v.x) & crossable(v.y) & crossable(v.z)) & ...);
}

/// from + t way, rounded; nothing if that is not certain, or if `way` may be parallel to the plane. The numbers are
/// `crossable`.
inline Perhaps<PlaneCrossing> crossing(const Point3d& from, const filters::Triple<Loose>& way,
                                       const Triangle3d& plane) {
  if (!rounds_to_nearest()) return std::nullopt;
  const auto normal = cross(loose_between(plane.a, plane.b), loose_between(plane.a, plane.c));
  const Loose rise = dot(normal, way);
  if (!rise.settled() || rise.high == 0) return std::nullopt;
  const Loose t = dot(normal, loose_between(from, plane.a)) / Divisor<double>(rise);
  const auto number = rounded(t);
  const auto point = rounded_along(from, t, way);
  if (!number || !point) return std::nullopt;
  return PlaneCrossing{*number, *point};
}

}  // namespace touchstone::robust::kernel
