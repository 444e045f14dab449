// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/planes/polygon_normal.h. Right, and every coordinate correctly rounded, for all finite doubles
/// in every floating-point environment.
PolygonNormal<double> polygon_normal(const Polygon3d& polygon);

/// The same, and which stage decided.
PolygonNormal<double> polygon_normal(const Polygon3d& polygon, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. There is no filter: numbers have to be
/// found.
std::optional<PolygonNormal<double>> polygon_normal_lattice(const Polygon3d& polygon);
PolygonNormal<double> polygon_normal_exact(const Polygon3d& polygon);

}  // namespace touchstone::robust
