// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "catalogue/draw/figures.h"
#include "catalogue/families/hard_case.h"
#include "catalogue/families/rings.h"

/// The questions of operations that cut one simple polygon into pieces, and the figures of the pieces.
namespace touchstone::catalogue {

/// Convex, star, comb; flat vertices, one in each edge or long runs; strips and needles of width 1; spirals; a slit
/// between two parts; coordinates near 1e6 + 0.1; up to 200 vertices; as people type and compute them; with the first
/// vertex once more at the end; and rings that are refused. All upright or lying, in either direction, from any vertex
/// on.
void simple_ring_cases(HardCases<std::tuple<Polygon2d>>& add);

/// The polygon and its pieces.
inline void draw_pieces(Drawing& drawing, const std::tuple<Polygon2d>& question,
                        const std::vector<std::vector<Index>>& pieces) {
  const Polygon2d& polygon = std::get<0>(question);
  draw(drawing, "polygon", polygon, false);
  for (const std::vector<Index>& piece : pieces) {
    Polygon2d part;
    for (const Index i : piece) part.vertices.push_back(polygon[i]);
    draw(drawing, "", part, true);
  }
}

}  // namespace touchstone::catalogue
