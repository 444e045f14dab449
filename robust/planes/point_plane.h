// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/plane_filter.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/planes/point_plane.h. Right, and the distance correctly rounded, for all finite doubles in every
/// floating-point environment.
PointPlane<double> point_plane(const Plane3d& plane, const Point3d& point);

/// The decision alone; and which stage decided.
inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point);
inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. The distance has no filter: a number has to
/// be found.
inline std::optional<PlaneSide> point_plane_side_filter(const Plane3d& plane, const Point3d& point);
std::optional<PlaneSide> point_plane_side_lattice(const Plane3d& plane, const Point3d& point);
PlaneSide point_plane_side_exact(const Plane3d& plane, const Point3d& point);
std::optional<PointPlane<double>> point_plane_lattice(const Plane3d& plane, const Point3d& point);
PointPlane<double> point_plane_exact(const Plane3d& plane, const Point3d& point);

/// Validation, then the stages after the filter.
PlaneSide point_plane_side_past_filter(const Plane3d& plane, const Point3d& point, Stage& decided);

inline std::optional<PlaneSide> point_plane_side_filter(const Plane3d& plane, const Point3d& point) {
  const filters::Sign sign = filters::plane(plane, point);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return sign == filters::Sign::positive ? PlaneSide::front : PlaneSide::back;
}

inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = point_plane_side_filter(plane, point)) return *answer;
  return point_plane_side_past_filter(plane, point, decided);
}

inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point) {
  if (const auto answer = point_plane_side_filter(plane, point)) return *answer;
  Stage ignored;
  return point_plane_side_past_filter(plane, point, ignored);
}

}  // namespace touchstone::robust
