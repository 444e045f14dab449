// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "geometry/space.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for the least and the greatest N . P of many points: the model, guards and rule (4) of filters.h.
namespace touchstone::robust::filters {

template <class Float, class Format = FloatFormat<Float>>
Float height(const Vector3<Float>& n, const Point3<Float>& p) {
  return n.x * p.x + n.y * p.y + n.z * p.z;
}

/// The greater of the sum of magnitudes so far and the point's.
template <class Float, class Format = FloatFormat<Float>>
Float greater_extent(const Point3<Float>& p, const Float& greatest) {
  const Float size = extent<Float, Format>(p.x, p.y, p.z);
  return size > greatest ? size : greatest;
}

template <class Float>
Float lower(const Float& value, const Float& low) {
  return value < low ? value : low;
}
template <class Float>
Float higher(const Float& value, const Float& high) {
  return value > high ? value : high;
}

/// A bound on the difference of two computed N . P whose order is not that of the exact ones. As in
/// robust/kernel/filters/plane_filter.h, 3 u + 48 u^2 times the product of the extents is enough for one of them, and
/// rounding the difference costs nothing (4): twice that is enough for two, three times are taken. Each is off by 15.1
/// n H for underflow: A is enough for two, 4 A are taken. Infinite if the guard does not hold.
template <class Float, class Format = FloatFormat<Float>>
Float doubt(const Vector3<Float>& n, const Float& of_points) {
  using B = Bounds<Float, Format>;
  const Float of_normal = extent<Float, Format>(n.x, n.y, n.z);
  if (!(of_normal + of_points <= B::high())) return std::numeric_limits<Float>::infinity();
  return B::template relative<18, 144>() * (of_normal * of_points) + 4 * B::absolute();
}

/// True if the N . P of value is certainly neither the least nor the greatest; low and high are the computed extremes.
/// Proved, for any number of points: kdop_right.
template <class Float>
bool between(const Float& value, const Float& low, const Float& high, const Float& apart) {
  return value - low > apart && high - value > apart;
}

}  // namespace touchstone::robust::filters
