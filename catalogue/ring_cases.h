// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "catalogue/families/rings.h"
#include "catalogue/figures.h"
#include "catalogue/row.h"

/// What the operations on one simple polygon that cut it into pieces are asked, and how their pieces are drawn.
namespace touchstone::audit {

/// Convex, star, comb; flat vertices, one in each edge or long runs; strips and needles of width 1; spirals; a slit
/// between two parts; coordinates near 1e6 + 0.1; up to 200 vertices; as
/// people type and compute them; and rings that are refused. All upright or lying,
/// in either direction, from any vertex on.
std::vector<HardCase<std::tuple<Polygon2d>>> simple_ring_cases();

/// The polygon, and the pieces as an implementation gives them.
template <class Pieces>
void draw_pieces(Scene& scene, const Polygon2d& polygon, const Pieces& pieces_of) {
  draw(scene, "polygon", polygon, false);
  try {
    for (const auto& piece : pieces_of(polygon)) {
      Polygon2d part;
      for (const Index i : piece) part.vertices.push_back(polygon[i]);
      draw(scene, "", part, true);
    }
  } catch (const InvalidInput&) {
    // No pieces: the scene's notes say why.
  }
}

}  // namespace touchstone::audit
