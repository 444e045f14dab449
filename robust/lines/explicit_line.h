// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/explicit_line.h. Right for all finite doubles in every floating-point environment.
inline Height explicit_line(double slope, double intercept, const Point2d& point);

/// The same, and which stage decided.
inline Height explicit_line(double slope, double intercept, const Point2d& point, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<Height> explicit_line_filter(double slope, double intercept, const Point2d& point);
std::optional<Height> explicit_line_lattice(double slope, double intercept, const Point2d& point);
Height explicit_line_exact(double slope, double intercept, const Point2d& point);

/// Validation, then the stages after the filter.
Height explicit_line_past_filter(double slope, double intercept, const Point2d& point, Stage& decided);

inline Height explicit_line_for(filters::Sign certain) {
  return certain == filters::Sign::positive ? Height::above : Height::below;
}

inline std::optional<Height> explicit_line_filter(double slope, double intercept, const Point2d& point) {
  const filters::Sign sign = filters::elevation(slope, intercept, point);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return explicit_line_for(sign);
}

inline Height explicit_line(double slope, double intercept, const Point2d& point, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = explicit_line_filter(slope, intercept, point)) return *answer;
  return explicit_line_past_filter(slope, intercept, point, decided);
}

/// The filter asked directly: g++ keeps an optional in memory.
inline Height explicit_line(double slope, double intercept, const Point2d& point) {
  const filters::Sign sign = filters::elevation(slope, intercept, point);
  if (sign != filters::Sign::unknown) return explicit_line_for(sign);
  Stage ignored;
  return explicit_line_past_filter(slope, intercept, point, ignored);
}

}  // namespace touchstone::robust
