// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/filters/sphere_box_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::filters {

/// Returns `disjoint` if a ball is certainly outside of the box around some points, and so outside of their hull, by
/// ball_and_box, which is proved; otherwise unknown. The ends of the box are selected by bits, since subnormals may be
/// read as zero; a NaN or an infinity becomes one of them, and then ball_and_box does not decide.
template <class... Points>
Perhaps<Contact> beyond_box(const Point3d& center, double radius, const Points&... points) {
  const auto on_axis = [](double c, double first, auto... others) {
    double min = first, max = first;
    ((min = kernel::ordered_bits(others) < kernel::ordered_bits(min) ? others : min), ...);
    ((max = kernel::ordered_bits(others) > kernel::ordered_bits(max) ? others : max), ...);
    return beyond_interval(c, min, max);
  };
  const Sign sign = ball_and_box<double>(radius, on_axis(center.x, points.x...), on_axis(center.y, points.y...),
                                         on_axis(center.z, points.z...));
  if (sign != Sign::negative) return std::nullopt;
  return Contact::disjoint;
}

}  // namespace touchstone::robust::filters
