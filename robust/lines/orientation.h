// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/orientation.h. Right for all finite doubles in every floating-point environment.
Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p);

/// The same, and which stage decided.
Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
std::optional<Side> orientation_lattice(const Point2d& p0, const Point2d& p1, const Point2d& p);
Side orientation_exact(const Point2d& p0, const Point2d& p1, const Point2d& p);

}  // namespace touchstone::robust
