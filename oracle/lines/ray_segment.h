// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the exact linear program over t >= 0 on the ray and s in [0, 1] on the segment; its Farkas vector is a
/// separating line, the least and the greatest t are the ends of what is common. Margin: the least squared distance of
/// the origin from the segment and of the segment's ends from the ray. For `none` that is the squared distance of the
/// two; 0 for every contact at an end and for `overlap`.
template <Exact Number = double>
Truth<RaySegment<Rational>> ray_segment(const Ray2<Number>& ray, const Segment2<Number>& segment);

}  // namespace touchstone::oracle
