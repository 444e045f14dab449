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

/// from + t way, rounded; nothing if numbers are not `moderate`, or if `way` may be parallel to the plane.
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
