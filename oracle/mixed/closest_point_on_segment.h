// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the segment of least squared distance, in rationals, by the conditions of Karush, Kuhn and
/// Tucker (oracle/exact/shapes/nearest_pair.h). The distance is the root of a rational. Nothing is decided: there
/// is no margin.
///
/// Certificate: "root": `weights` of the segment's ends, which give the point; the conditions hold with it. Where the
/// distance is not rational the same, called "irrational_root".
template <Exact Number = double>
Truth<ClosestPoint2<Surd>> closest_point_on_segment(const Point2<Number>& point, const Segment2<Number>& segment);
template <Exact Number = double>
Truth<ClosestPoint3<Surd>> closest_point_on_segment(const Point3<Number>& point, const Segment3<Number>& segment);

}  // namespace touchstone::oracle
