// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

namespace detail {

/// Compares bits, because subnormals may be read as zero.
inline double clamped(double x, double min, double max) {
  using kernel::ordered_bits;
  const double above = ordered_bits(x) < ordered_bits(min) ? min : x;
  return ordered_bits(x) > ordered_bits(max) ? max : above;
}

template <class Point, class Box>
void validate_with_box(const Point& point, const Box& aabb) {
  if (!kernel::valid(point) || !kernel::valid(aabb))
    validation::validate("point", point), validation::validate("aabb", aabb);
}

}  // namespace detail

/// The point of an axis-aligned box, as a closed solid, that is nearest to a point: the point itself if it lies in the
/// box. In the plane and in space.
///
/// Exact for all finite doubles in every floating-point environment: each coordinate is, bit for bit, that of the
/// point, of min or of max. A flat box is valid. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so does min > max ("min <= max"). Contract: reference/volumes/closest_point_on_aabb.h.
inline Point2d closest_point_on_aabb(const Point2d& point, const Aabb2d& aabb) {
  detail::validate_with_box(point, aabb);
  const auto& [min, max] = aabb;
  return {detail::clamped(point.x, min.x, max.x), detail::clamped(point.y, min.y, max.y)};
}
inline Point3d closest_point_on_aabb(const Point3d& point, const Aabb3d& aabb) {
  detail::validate_with_box(point, aabb);
  const auto& [min, max] = aabb;
  return {detail::clamped(point.x, min.x, max.x), detail::clamped(point.y, min.y, max.y),
          detail::clamped(point.z, min.z, max.z)};
}

}  // namespace touchstone::robust
