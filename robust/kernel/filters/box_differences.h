// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Conclusions from differences of numbers of two boxes, valid in every environment. A computed x - y > 0 proves x > y:
/// rounding keeps the sign of a difference or makes it 0, and reading subnormals as zero makes numbers equal but never
/// exchanges them. The same for < 0; 0 proves nothing.
struct BoxDifferences {
  double depth;   ///< the least over the axes of min(a.max, b.max) - max(a.min, b.min)
  double extent;  ///< the least max - min of a box on an axis
  double total;   ///< the sum of max - min over the axes of both boxes

  /// extent > 0: each box has min < max on every axis. Then a finite sum means that all numbers are finite: no two
  /// terms of it cancel, and the difference of an infinity and another number is infinite in every rounding mode. NaN
  /// fails the comparison with the sum, to which every number contributes; so does a sum of finite numbers that
  /// overflows, which only costs time.
  bool certain() const {
    return (static_cast<int>(total <= std::numeric_limits<double>::max()) & static_cast<int>(extent > 0) &
            static_cast<int>((depth > 0) | (depth < 0))) != 0;
  }
  /// Requires certain(). depth > 0: on every axis the intervals have more than a point in common. depth < 0: on some
  /// axis they have nothing in common.
  Contact contact() const { return depth > 0 ? Contact::overlapping : Contact::disjoint; }
};

inline double lesser(double x, double y) { return x < y ? x : y; }
inline double greater(double x, double y) { return x > y ? x : y; }

inline BoxDifferences differences_on_axis(double a_min, double a_max, double b_min, double b_max) {
  const double a_extent = a_max - a_min, b_extent = b_max - b_min;
  return {lesser(a_max, b_max) - greater(a_min, b_min), lesser(a_extent, b_extent), a_extent + b_extent};
}
inline BoxDifferences together(const BoxDifferences& s, const BoxDifferences& t) {
  return {lesser(s.depth, t.depth), lesser(s.extent, t.extent), s.total + t.total};
}
inline BoxDifferences differences(const Aabb2d& a, const Aabb2d& b) {
  return together(differences_on_axis(a.min.x, a.max.x, b.min.x, b.max.x),
                  differences_on_axis(a.min.y, a.max.y, b.min.y, b.max.y));
}
inline BoxDifferences differences(const Aabb3d& a, const Aabb3d& b) {
  return together(together(differences_on_axis(a.min.x, a.max.x, b.min.x, b.max.x),
                           differences_on_axis(a.min.y, a.max.y, b.min.y, b.max.y)),
                  differences_on_axis(a.min.z, a.max.z, b.min.z, b.max.z));
}

}  // namespace touchstone::robust::kernel
