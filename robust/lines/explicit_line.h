// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies above, on or below the line y = slope x + intercept, y up.
///
/// `on` means exactly on the line, however near the others are. No vertical line has this form; a slope of 0 is valid.
/// Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names
/// the field and "finite number". Contract: reference/lines/explicit_line.h.
inline Height explicit_line(double slope, double intercept, const Point2d& point);

namespace stages {

struct explicit_line : Filtered<explicit_line, decltype(robust::explicit_line)> {
  static Perhaps<Height> filter(double slope, double intercept, const Point2d& point) {
    return filters::by_sign(filters::elevation(slope, intercept, point), Height::above, Height::below);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline Height explicit_line(double slope, double intercept, const Point2d& point) {
  return stages::explicit_line::ask(slope, intercept, point).answer;
}

}  // namespace touchstone::robust
