// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/points.h"
#include "geometry/words.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides on which side of the directed line p0 -> p1 the point p lies, y up: `left` is counter-clockwise.
///
/// `on` means exactly on the line, however close to either side; if p0 == p1 every point is on it. Right for all finite
/// doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number". Contract: reference/lines/orientation.h.
inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p);

namespace stages {

struct orientation : Filtered<orientation, decltype(robust::orientation)> {
  static Perhaps<Side> filter(const Point2d& p0, const Point2d& p1, const Point2d& p) {
    return filters::by_sign(filters::orientation(p0, p1, p), Side::left, Side::right);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  return stages::orientation::ask(p0, p1, p).answer;
}

}  // namespace touchstone::robust
