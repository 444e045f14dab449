// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/triangles.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: exact linear programs for a plane that has one triangle on either side and not both within itself; what is
/// common is within that plane, so the corners off it are left out, and the rest is asked again. If no corner of a
/// triangle is left, there is no intersection; where no such plane is left, what is left of both meets in the middle,
/// and the common part is as large as that of the planes, lines or points on which they lie. Margin: the least squared
/// distance of a corner from the other triangle, or of two edges. For `none` that is the squared distance of the two; 0
/// if they only touch, and for `area`. Certificate: those planes, and one to three common points, by weights of the
/// corners of each, of the dimension in the truth.
template <Exact Number = double>
Truth<TriangleTriangleRelation> triangle_triangle(const Triangle3<Number>& a, const Triangle3<Number>& b);

/// The same relation alone; of integers below 2^13 in size without linear programs.
TriangleTriangleRelation triangle_triangle_relation(const Triangle3d& a, const Triangle3d& b);
TriangleTriangleRelation triangle_triangle_relation(const Triangle3<std::int64_t>& a, const Triangle3<std::int64_t>& b);

}  // namespace touchstone::oracle
