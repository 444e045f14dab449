// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/implicit_circle.h. Right for all finite doubles in every floating-point environment.
Location implicit_circle(const Circle2d& circle, const Point2d& point);

/// The same, and which stage decided.
Location implicit_circle(const Circle2d& circle, const Point2d& point, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
std::optional<Location> implicit_circle_lattice(const Circle2d& circle, const Point2d& point);
Location implicit_circle_exact(const Circle2d& circle, const Point2d& point);

}  // namespace touchstone::robust
