// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/filters/sphere_box_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::filters {

/// `disjoint` where a ball is certainly beyond the box around some points, and so beyond all that is between them:
/// ball_and_box, which is proved. Else unknown. The ends of the box are chosen as bits, since subnormals may be read as
/// zero; what is NaN or infinite is one of them, and then ball_and_box does not know.
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
