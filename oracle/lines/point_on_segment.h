// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: with v = b - a and w = point - a on integers, `on` means collinear, (w.v)^2 = (w.w)(v.v), and between, 0 <=
/// w.v <= v.v. Margin: the squared distance of the point from the segment, so 0 for `on`.
template <Exact Number = double>
Truth<PointOnSegment<Rational>> point_on_segment(const Point2<Number>& point, const Segment2<Number>& segment);

}  // namespace touchstone::oracle
