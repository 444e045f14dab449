// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/implicit_circle.h. Right for all finite doubles in every floating-point environment.
inline Location implicit_circle(const Circle2d& circle, const Point2d& point);

/// The same, and which stage decided.
inline Location implicit_circle(const Circle2d& circle, const Point2d& point, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<Location> implicit_circle_filter(const Circle2d& circle, const Point2d& point);
std::optional<Location> implicit_circle_lattice(const Circle2d& circle, const Point2d& point);
Location implicit_circle_exact(const Circle2d& circle, const Point2d& point);

/// Validation, then the stages after the filter.
Location implicit_circle_past_filter(const Circle2d& circle, const Point2d& point, Stage& decided);

inline filters::Sign implicit_circle_sign(const Circle2d& circle, const Point2d& point) {
  if (std::signbit(circle.radius)) return filters::Sign::unknown;  // -0.0, or for validation to refuse
  return filters::circle(point - circle.center, circle.radius);
}

inline Location implicit_circle_for(filters::Sign certain) {
  return certain == filters::Sign::positive ? Location::inside : Location::outside;
}

inline std::optional<Location> implicit_circle_filter(const Circle2d& circle, const Point2d& point) {
  const filters::Sign sign = implicit_circle_sign(circle, point);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return implicit_circle_for(sign);
}

inline Location implicit_circle(const Circle2d& circle, const Point2d& point, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = implicit_circle_filter(circle, point)) return *answer;
  return implicit_circle_past_filter(circle, point, decided);
}

/// The filter asked directly: g++ keeps an optional in memory.
inline Location implicit_circle(const Circle2d& circle, const Point2d& point) {
  const filters::Sign sign = implicit_circle_sign(circle, point);
  if (sign != filters::Sign::unknown) return implicit_circle_for(sign);
  Stage ignored;
  return implicit_circle_past_filter(circle, point, ignored);
}

}  // namespace touchstone::robust
