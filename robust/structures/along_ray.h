// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/control_word.h"

/// The times at which a ray meets valid boxes, exactly. Call while a kernel::ControlWord is in scope.
namespace touchstone::robust::structures {

/// A time on a ray, (bound - origin) / direction of one axis, within an interval of doubles.
struct Moment {
  double low = 0, high = 0;
  double bound = 0, origin = 0, direction = 1;

  /// The start, t = 0.
  Moment() = default;
  /// direction is not 0.
  ///
  /// Rounding is to nearest with gradual underflow, u = 2^-53: the difference is off by u of it, unless it overflows;
  /// the quotient by u more, and by 2^-1075 where it underflows. A t as computed that is at most 2^1000 comes of no
  /// overflow, or of an infinite divided by a finite number, which is infinite. So t is off by (2 + 3u) u |t| +
  /// 2^-1075, for which 4 u |t| + 2^-1074, rounded twice, has 2 u |t| - 2^-1074 to spare, and the ends, rounded, stay
  /// outside. A greater t may be anywhere. Not proved by machine.
  Moment(double to, double from, double step);
};

/// Returns -1, 0 or 1 for earlier, equal or later. Decides by their intervals; if these overlap, exactly.
int compare(const Moment& a, const Moment& b);

/// The first time at which a ray is in a box; empty: never.
std::optional<Moment> first_moment(const Ray3d& ray, const Aabb3d& box);

/// Bodies sorted by their first time, those with the same time by their index.
std::vector<Index> in_order(std::vector<std::pair<Moment, Index>> met);

}  // namespace touchstone::robust::structures
