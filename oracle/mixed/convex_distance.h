// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/polyhedra.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: `meeting` where a linear program finds weights of a's vertices and of b's that give one point. Otherwise the
/// least distance of a vertex, edge or face of a from one of b, all pairs tried in integers: the nearest points of
/// solids are on these. Where there are many such points they are in one plane, and the one that is nearest to
/// a.vertices[0] is its foot on that plane, or on an edge, or a vertex, or where two edges cross: all of these that are
/// in both solids are tried.
///
/// Margin: a length, how far a has to be moved in the maximum norm until the relation changes, by linear programs.
///
/// Certificate: meeting: `on_a` and `on_b`, weights of all vertices that give one point ("common_point"). apart: "root"
/// or "irrational_root", as closest_point_on_segment has them; `on_a` and `on_b`, weights of all vertices that give
/// points nothing of the other solid is nearer to; and `first`, a vector that no vertex of a comes before, seen from
/// the nearest point, while none of b comes before the rest of the displacement from a.vertices[0]: a nearest pair at a
/// smaller distance from a.vertices[0] would have to.
template <Exact Number = double>
Truth<ConvexDistance<Surd>> convex_distance(const Mesh<Number>& a, const Mesh<Number>& b);

/// Among all pairs of points of disjoint solids that are as near as those of the truth, the one whose point of a is
/// nearest to `on_a`. No other truth rests on it.
ConvexDistance<Surd> as_near(const Meshd& a, const Meshd& b, const ConvexDistance<Surd>& truth, const Point3d& on_a);

}  // namespace touchstone::oracle
