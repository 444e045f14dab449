// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/triangles.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: any pair of nearest points by the conditions of Karush, Kuhn and Tucker (any_nearest_pair of
/// oracle/exact/shapes/nearest_pair.h), which meet where the distance is 0. If corners as far along the displacement
/// leave other pairs as near, the points of a of all pairs are the hull of the corners of each of those parts that are
/// in the other, moved there, and of the points where edges cross; by the same conditions, the one of it that is
/// nearest to a's first corner.
///
/// Margin: apart, the squared distance; meeting, the least squared distance of the origin from the planes that bound
/// the Minkowski difference, whose normals are those of the triangles and the cross products of their edges.
///
/// Certificate: as convex_distance has it, with the weights of three corners each.
template <Exact Number = double>
Truth<ConvexDistance<Surd>> triangle_triangle_distance(const Triangle3<Number>& a, const Triangle3<Number>& b);

/// Among all pairs of points of disjoint triangles that are as near as any, the one whose point of a is nearest to
/// `on_a`. No other truth rests on it.
ConvexDistance<Surd> as_near(const Triangle3d& a, const Triangle3d& b, const ConvexDistance<Surd>& truth,
                             const Point3d& on_a);

}  // namespace touchstone::oracle
