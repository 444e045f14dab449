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

/// The door, then the stages after the filter.
Location implicit_circle_past_filter(const Circle2d& circle, const Point2d& point, Stage& decided);

inline std::optional<Location> implicit_circle_filter(const Circle2d& circle, const Point2d& point) {
  if (std::signbit(circle.radius)) return std::nullopt;  // -0.0, or for the door to refuse
  const filters::Sign sign = filters::circle(point - circle.center, circle.radius);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return sign == filters::Sign::positive ? Location::inside : Location::outside;
}

inline Location implicit_circle(const Circle2d& circle, const Point2d& point, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = implicit_circle_filter(circle, point)) return *answer;
  return implicit_circle_past_filter(circle, point, decided);
}

inline Location implicit_circle(const Circle2d& circle, const Point2d& point) {
  if (const auto answer = implicit_circle_filter(circle, point)) return *answer;
  Stage ignored;
  return implicit_circle_past_filter(circle, point, ignored);
}

}  // namespace touchstone::robust
