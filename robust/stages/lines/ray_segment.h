// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/ray_segment.h"

namespace touchstone::robust::stages {

struct ray_segment {
  static Perhaps<RaySegment<double>> enclosed(const Ray2d& ray, const Segment2d& segment);
  static Perhaps<RaySegment<double>> lattice(const Ray2d& ray, const Segment2d& segment);
  static RaySegment<double> exact(const Ray2d& ray, const Segment2d& segment);

  struct decision : detail::ray_segment_relation {
    static Perhaps<RayRelation> lattice(const Ray2d& ray, const Segment2d& segment);
    static RayRelation exact(const Ray2d& ray, const Segment2d& segment);
  };
};

}  // namespace touchstone::robust::stages
