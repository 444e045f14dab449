// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the exact linear program over the weights of the segment's ends and of the triangle's corners: the least and
/// the greatest t of a common point. Margin: the least squared distance of an end of the segment from the triangle, or
/// of the segment from one of its edges. For `none` that is the squared distance of the two; 0 for every contact at an
/// end or an edge and for `segment`. Certificate: the Farkas vector is a separating plane; of what is common, weights
/// of the first and of the last point, and planes that keep the triangle from what comes before and after.
template <Exact Number = double>
Truth<SegmentTriangle<Rational>> segment_triangle(const Segment3<Number>& segment, const Triangle3<Number>& triangle);

}  // namespace touchstone::oracle
