// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/orientation.h. Right for all finite doubles in every floating-point environment.
inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p);

/// The same, and which stage decided.
inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<Side> orientation_filter(const Point2d& p0, const Point2d& p1, const Point2d& p);
std::optional<Side> orientation_lattice(const Point2d& p0, const Point2d& p1, const Point2d& p);
Side orientation_exact(const Point2d& p0, const Point2d& p1, const Point2d& p);

/// Validation, then the stages after the filter.
Side orientation_past_filter(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided);

inline Side orientation_for(filters::Sign certain) {
  return certain == filters::Sign::positive ? Side::left : Side::right;
}

inline std::optional<Side> orientation_filter(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const filters::Sign sign = filters::orientation(p0, p1, p);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return orientation_for(sign);
}

inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = orientation_filter(p0, p1, p)) return *answer;
  return orientation_past_filter(p0, p1, p, decided);
}

/// The filter asked directly: g++ keeps an optional in memory.
inline Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const filters::Sign sign = filters::orientation(p0, p1, p);
  if (sign != filters::Sign::unknown) return orientation_for(sign);
  Stage ignored;
  return orientation_past_filter(p0, p1, p, ignored);
}

}  // namespace touchstone::robust
