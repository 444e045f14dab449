// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "reference/polygons/triangulate_polygon.h"

namespace touchstone::reference {

/// Cuts a simple polygon into convex pieces whose corners are its vertices: counter-clockwise lists of indices.
///
/// Deck p. 7: a triangulation, then triangles are merged across the diagonals that are not needed (Hertel and
/// Mehlhorn): one diagonal after the other is taken out if at neither end the angle that it divided is more than half a
/// turn, E >= 0 as in triangulate_polygon.
///
/// polygon: simple, in either direction; any unit of length. Many answers are right: every piece is convex (flat angles
/// allowed) and of positive area, the interiors of no two meet, together they are the polygon, every vertex on the
/// boundary of a piece is in its list, and there are at most 2 r + 1 of them, r the number of reflex vertices. No
/// partition has fewer than r / 2 + 1, so that is at most four times the least number. (Why Hertel and Mehlhorn's has
/// no more: a diagonal left over is needed by a reflex vertex at one of its ends, and no vertex needs three, which
/// would divide more than a full turn.) Degenerate: a flat vertex is no reason to cut, and stays in the list of its
/// piece. A last position that repeats the first is dropped, and what is refused is, as in triangulate_polygon.
///
/// Rounding: as triangulate_polygon. Where the sum and every E of three of the vertices exceed their bounds, every
/// decision is right, and so is the answer. In exact arithmetic the formula is always right.
template <class Real>
std::vector<std::vector<Index>> convex_partition(const Polygon2<Real>& polygon) {
  std::vector<std::vector<Index>> pieces = triangulate_polygon(polygon);
  const auto turns_right = [&](Index i, Index j, Index k) {
    const Point2<Real>&p0 = polygon[i], &p1 = polygon[j], &p = polygon[k];
    return Real(Real((p.y - p0.y) * (p1.x - p0.x)) - Real((p.x - p0.x) * (p1.y - p0.y))) < Real(0);
  };
  // The piece of each directed edge, and the edge's place in it.
  const auto find = [&](Index from, Index to) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = 0; k < pieces[i].size(); ++k) {
        if (pieces[i][k] == from && pieces[i][(k + 1) % pieces[i].size()] == to) return std::pair(i, k);
      }
    }
    return std::pair(pieces.size(), std::size_t{0});
  };
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& triangle : pieces) {
    for (std::size_t k = 0; k < triangle.size(); ++k)
      edges.emplace_back(triangle[k], triangle[(k + 1) % triangle.size()]);
  }
  for (const auto& [from, to] : edges) {
    const auto [i, k] = find(from, to);
    const auto [j, l] = find(to, from);
    if (i == pieces.size() || j == pieces.size() || i == j) continue;
    // from .. to of the one, then on from `to` in the other up to before `from`.
    std::vector<Index> one = pieces[i], other = pieces[j];
    std::rotate(one.begin(), one.begin() + static_cast<std::ptrdiff_t>((k + 1) % one.size()),
                one.end());  // to ... from
    std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>((l + 1) % other.size()),
                other.end());  // from ... to
    if (turns_right(other[other.size() - 2], to, one[1]) || turns_right(one[one.size() - 2], from, other[1])) continue;
    one.insert(one.end(), other.begin() + 1, other.end() - 1);
    pieces[std::min(i, j)] = one;
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
  }
  return pieces;
}

}  // namespace touchstone::reference
