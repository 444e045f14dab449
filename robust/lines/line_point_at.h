// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point origin + t direction of a line; t is in units of the direction's length, and has any sign.
///
/// Both coordinates correctly rounded for all finite doubles, in every floating-point environment; beyond the range
/// they are infinite. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does a
/// direction of length 0 ("nonzero direction"). Contract: reference/lines/line_point_at.h.
Point2d line_point_at(const ParametricLine2d& line, double t);

namespace stages {

/// There is no filter: a number has to be computed.
struct line_point_at : Signatures<decltype(robust::line_point_at)> {
  static Partial enclosed, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
