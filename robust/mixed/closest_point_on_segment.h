// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point of a closed segment that is nearest to a point, the distance and its square. In the plane and in space.
///
/// A segment of length 0 is a point. Right for all finite doubles in every floating-point environment, and every number
/// correctly rounded on its own: the distance is neither the root of the rounded square nor measured from the rounded
/// point. NaN and infinities throw InvalidInput, which names the field and "finite number". Contract:
/// reference/mixed/closest_point_on_segment.h.
ClosestPoint2<double> closest_point_on_segment(const Point2d& point, const Segment2d& segment);
ClosestPoint3<double> closest_point_on_segment(const Point3d& point, const Segment3d& segment);

namespace stages {

struct closest_point_on_segment {
  static Perhaps<ClosestPoint2<double>> enclosed(const Point2d& point, const Segment2d& segment);
  static Perhaps<ClosestPoint3<double>> enclosed(const Point3d& point, const Segment3d& segment);
  static ClosestPoint2<double> exact(const Point2d& point, const Segment2d& segment);
  static ClosestPoint3<double> exact(const Point3d& point, const Segment3d& segment);
  static Decided<ClosestPoint2<double>> ask(const Point2d& point, const Segment2d& segment);
  static Decided<ClosestPoint3<double>> ask(const Point3d& point, const Segment3d& segment);
};

}  // namespace stages

}  // namespace touchstone::robust
