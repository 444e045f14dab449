// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the ray is cut far behind all corners; the exact linear program over the weights of that segment's ends and
/// of the triangle's corners gives the least and the greatest t of a common point. Inside: all three weights are
/// positive, and the triangle has an area. Margin: the least squared distance of the origin from the triangle, or of
/// the ray from one of its edges. For `none` that is the squared distance of the two; 0 for every point at the origin
/// or on the boundary and for `segment`. Certificate: `until`, a t from which on the ray is farther ahead than all
/// corners, with a plane that separates the triangle from what comes before; of what is common, weights of the first
/// and of another point, and planes that keep the triangle from what comes before and after.
template <Exact Number = double>
Truth<RayTriangle<Rational>> ray_triangle(const Ray3<Number>& ray, const Triangle3<Number>& triangle);

}  // namespace touchstone::oracle
