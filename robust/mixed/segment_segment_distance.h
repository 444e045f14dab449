// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// A pair of nearest points of two closed segments, their distance and its square. In the plane and in space.
///
/// For parallel segments with several nearest pairs, the pair with the least parameter on a. A segment of length 0 is
/// a point. Right for all finite doubles in every floating-point environment, and every number correctly rounded on its
/// own: the distance is neither the root of the rounded square nor that of the rounded points. NaN and infinities throw
/// InvalidInput, which names the field and "finite number". Contract: reference/mixed/segment_segment_distance.h.
ClosestPair2<double> segment_segment_distance(const Segment2d& a, const Segment2d& b);
ClosestPair3<double> segment_segment_distance(const Segment3d& a, const Segment3d& b);

namespace stages {

struct segment_segment_distance {
  static Perhaps<ClosestPair2<double>> enclosed(const Segment2d& a, const Segment2d& b);
  static Perhaps<ClosestPair3<double>> enclosed(const Segment3d& a, const Segment3d& b);
  static ClosestPair2<double> exact(const Segment2d& a, const Segment2d& b);
  static ClosestPair3<double> exact(const Segment3d& a, const Segment3d& b);
  static Decided<ClosestPair2<double>> ask(const Segment2d& a, const Segment2d& b);
  static Decided<ClosestPair3<double>> ask(const Segment3d& a, const Segment3d& b);
};

}  // namespace stages

}  // namespace touchstone::robust
