// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include "oracle/certificates/check_reading.h"

/// Shared by the checks of polygons.
namespace touchstone::certify {

/// The vertices of a closed ring.
using Ring = std::vector<Pair>;

/// The edge from vertex i to the next; all edges, of several rings one after the other.
Ends edge(const Ring& ring, std::size_t i);
std::vector<Ends> edges_of(const std::vector<Ring>& rings);

/// 1, 0, -1: p lies to the left of the directed line through the ends, on it, to the right.
int side(const Ends& line, const Pair& p);

/// Requires that no two neighbours are equal, and not all vertices are collinear: with different neighbours some three
/// of them turn.
void expect_not_degenerate(const Ring& ring);

/// True if two edges have a common point: unless all of one lies strictly on one side of the other's line, or further
/// along in x or in y.
bool meet(const Ends& a, const Ends& b);

/// The first defect of all, edges i <= j: i has length zero, and j is the same; or i meets j at a point other than a
/// vertex that neighbours share. Edges of length zero come before all others, then the least i, then the least j.
std::optional<std::pair<std::size_t, std::size_t>> defect(const Ring& ring);

/// Requires that the input's ring `what` has no defect.
void expect_simple(const Ring& ring, const std::string& what);
void expect_no_edge_of_length_zero(const Ring& ring, const std::string& what);

/// A number of the certificate that is the index of a vertex; of one of so many edges.
std::size_t vertex(const Rational& index, const Ring& ring);
std::size_t index_below(std::size_t count, const Rational& index);

/// A region's rings, the outer one first. Requires that each is simple, and that they fit together: no two cross or run
/// along each other, and with each edge cut at the vertices of the other ring, the middles of the pieces of a hole are
/// inside the outer ring, and those of two holes outside the other one. So the boundary of a hole is nowhere beyond the
/// outer ring; and a common inside of two holes would be bounded by what the boundaries have in common, which is
/// points.
std::vector<Ring> region(const json& value, const std::string& what);

}  // namespace touchstone::certify
