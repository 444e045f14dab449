// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: by linear programming over the weights of the triangle's corners, how far a point of the triangle can be
/// within the planes of all six faces of the box; more than 0: they overlap, 0: they touch, less: they are disjoint. On
/// integers.
///
/// Margin: a length, the magnitude of that: overlapping, how far every face has to be moved inwards until they only
/// touch; disjoint, outwards, which is their distance in the maximum norm.
///
/// Certificate: disjoint: "separating_plane" (`normal`, `offset`), the triangle below it and the box above. Otherwise
/// the `weights` of a common point: "supporting_plane", or "flat_axis" (the `axis` on which the box is flat), where
/// they touch; "common_interior_point" where they overlap.
template <Exact Number = double>
Truth<Contact> triangle_aabb(const Triangle3<Number>& triangle, const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
