// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/plane_filter.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/planes/point_plane_toi.h. Right, and t and point correctly rounded, for all finite doubles in
/// every floating-point environment.
PointPlaneToi<double> point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end);

/// The same, and which stage decided.
PointPlaneToi<double> point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. The filter knows the steps that stay on one
/// side of the plane, or start behind it: no number has to be found.
std::optional<PointPlaneToi<double>> point_plane_toi_filter(const Plane3d& plane, const Point3d& start,
                                                            const Point3d& end);
std::optional<PointPlaneToi<double>> point_plane_toi_lattice(const Plane3d& plane, const Point3d& start,
                                                             const Point3d& end);
PointPlaneToi<double> point_plane_toi_exact(const Plane3d& plane, const Point3d& start, const Point3d& end);

}  // namespace touchstone::robust
