// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/line_point_at.h. Both coordinates correctly rounded for all finite doubles, in every
/// floating-point environment.
Point2d line_point_at(const ParametricLine2d& line, double t);

/// The same, and which stage decided (the later one, where the coordinates took different stages).
Point2d line_point_at(const ParametricLine2d& line, double t, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. There is no filter: a number has to be
/// found.
std::optional<Point2d> line_point_at_lattice(const ParametricLine2d& line, double t);
Point2d line_point_at_exact(const ParametricLine2d& line, double t);

}  // namespace touchstone::robust
