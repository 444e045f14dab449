// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: points of both segments of least squared distance, in rationals, by the conditions of Karush, Kuhn and Tucker
/// (oracle/exact/shapes/nearest_pair.h); of all pairs that satisfy them the one with the least parameter on a. The
/// distance is as closest_point_on_segment has it. Nothing is decided: there is no margin.
///
/// Certificate: "root" or "irrational_root", as closest_point_on_segment has them; `on_a` and `on_b`, the weights of
/// the ends. That no pair with a smaller parameter on a is as near follows from the directions.
template <Exact Number = double>
Truth<ClosestPair2<Surd>> segment_segment_distance(const Segment2<Number>& a, const Segment2<Number>& b);
template <Exact Number = double>
Truth<ClosestPair3<Surd>> segment_segment_distance(const Segment3<Number>& a, const Segment3<Number>& b);

/// Among all pairs of points that are as near as those of the truth, the one whose point of a is nearest to `on_a`. No
/// other truth rests on it.
ClosestPair2<Surd> as_near(const Segment2d& a, const Segment2d& b, const ClosestPair2<Surd>& truth,
                           const Point2d& on_a);
ClosestPair3<Surd> as_near(const Segment3d& a, const Segment3d& b, const ClosestPair3<Surd>& truth,
                           const Point3d& on_a);

}  // namespace touchstone::oracle
