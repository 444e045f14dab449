// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/point_on_segment.h"

namespace touchstone::robust::stages {

struct point_on_segment {
  static Perhaps<PointOnSegment<double>> lattice(const Point2d& point, const Segment2d& segment);
  static PointOnSegment<double> exact(const Point2d& point, const Segment2d& segment);

  struct decision : detail::point_on_segment_relation {
    static Perhaps<Incidence> lattice(const Point2d& point, const Segment2d& segment);
    static Incidence exact(const Point2d& point, const Segment2d& segment);
  };
};

}  // namespace touchstone::robust::stages
