// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Tests whether a ring of at least three finite vertices, with distinct neighbours, is simple: exactly, in time n log
/// n. Like everything here, it must be called with gradual underflow (kernel/control_word.h).
bool simple_by_sweep(const Polygon2d& ring);

/// The same sweep, which also produces triangles: n - 2 counter-clockwise triples of indices, each of positive area.
/// Returns nullopt if the ring is not simple. The stage is the latest that a decision needed.
///
/// Method. Between an edge with the inside above it (a floor) and the next one above (its ceiling) the part of the
/// inside that has been swept over and not cut off yet lies to the right of a chain of vertices, from the floor's left
/// end up to the ceiling's. Every vertex that the line reaches joins the adjacent chains, and then triangles of it
/// and the next two of the chain are cut off while these three turn strictly left:
///   - v ends one edge and begins another: v joins its chain at the floor's or the ceiling's end.
///   - v begins two edges outside: v alone is a new chain.
///   - v begins two edges inside: v is joined to the chain's latest vertex r, where the chain is split: up to r, v and
///     from v, r on.
///   - v ends two edges with the inside between them: the chain closes and is cut off completely.
///   - v ends two edges with the outside between them: v joins both chains, which become one.
/// (1) Within a chain no three turn left, as seen from v: what would is cut off. So no vertex within it comes before
///     both of its neighbours, and the chain goes on in the order of the sweep up to r and then back.
/// (2) Whatever is cut off is free of other vertices, boundary included: those of the chain lie beyond the line through
///     the two, because from there on the chain bends away from v or goes straight on; and between chain and line there
///     is nothing else.
/// (3) r sees v, where two edges begin inside: nothing comes between them in the order of the sweep.
/// (4) A chain that closes with v is a simple ring in which v and the chain's two ends alone may turn left. A
///     simple ring of more than three vertices has two that turn left, are not neighbours and can be cut off with
///     positive area (it has a triangulation without flat triangles:
///     reference/polygons/triangulate_polygon.h); these are the ends. So each step of cutting it off has positive area.
/// The order by x and then by y is the order by x after a turn by a small angle: points with the same x are no special
/// case.
std::optional<Decided<std::vector<std::vector<Index>>>> triangulated_by_sweep(const Polygon2d& ring);

}  // namespace touchstone::robust
