// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "geometry/solids.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: boxes by comparing; space is cut by planes into convex cells, until each is outside of one solid
/// (oracle/exact/solids/space_partition.h). Where that can be done with closed cells, no point is common; where it can
/// be done with open cells, no interior point is; otherwise a cell is found that is inside of both. The step by asking
/// point_in_polyhedron about every vertex that a face names. Margin: as the contract says, from the squared distances
/// of faces, or of vertices from faces.
///
/// Certificate: of bounding_volumes "separating_axis" (the `axis`, and a `value` between the boxes); of other disjoint
/// solids "partition" (the `tree` of cells, the `planes` that cut them, a point of each in `points`, and as parts
/// proofs that it is `outside`); of touching ones "touching" (such a partition, and a common point); of overlapping
/// ones "common_interior_point". A common point has a proof for each solid, `in_a` and `in_b`. With both kinds goes the
/// step: a `vertex` that is inside with its proof in `vertices`, or proofs there that no vertex is.
template <Exact Number = double>
Truth<PolyhedronPolyhedron> polyhedron_polyhedron(const Mesh<Number>& a, const Mesh<Number>& b);

}  // namespace touchstone::oracle
