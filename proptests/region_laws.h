// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "proptests/laws.h"

/// Regions for the laws and examples of their operations.
namespace touchstone::proptests {

/// A square of side 8 with a square hole of side 4.
inline const Region2d frame{{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}}, {{{{2, 2}, {6, 2}, {6, 6}, {2, 6}}}}};

/// The same set: every ring from another vertex on and in the other direction, the holes in the opposite order.
inline Region2d rewritten(Region2d region) {
  const auto rewrite = [](Polygon2d& ring) {
    if (validation::closed(ring.vertices)) ring.vertices.pop_back();
    std::rotate(ring.vertices.begin(), ring.vertices.begin() + 1, ring.vertices.end());
    std::reverse(ring.vertices.begin(), ring.vertices.end());
  };
  rewrite(region.outer);
  for (Polygon2d& hole : region.holes) rewrite(hole);
  std::reverse(region.holes.begin(), region.holes.end());
  return region;
}

/// refuse(region, field, rule) for regions that break one rule each, named `name`.
template <class Refuse>
void refused_regions(const std::string& name, const Refuse& refuse) {
  const std::string inside = "inside the outer ring, which it may touch in single points only";
  const auto outside = [](int other) {
    return "outside hole " + std::to_string(other) + ", which it may touch in single points only";
  };
  const auto with = [](std::vector<Polygon2d> holes) {
    holes.insert(holes.begin(), frame.holes[0]);
    return Region2d{frame.outer, std::move(holes)};
  };
  const auto box = [](double x, double y, double width, double height) {
    return Polygon2d{{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}};
  };
  refuse(with({box(9, 0, 1, 1)}), name + ".holes[1]", inside);            // beyond
  refuse(with({box(7, 1, 2, 1)}), name + ".holes[1]", inside);            // across an edge
  refuse(with({box(7, 1, 1, 1)}), name + ".holes[1]", inside);            // along an edge
  refuse(with({box(-1, -1, 10, 10)}), name + ".holes[1]", inside);        // around
  refuse({frame.outer, {frame.outer}}, name + ".holes[0]", inside);       // the same
  refuse(with({box(6, 3, 1, 1)}), name + ".holes[1]", outside(0));        // along an edge
  refuse(with({box(5, 3, 2, 1)}), name + ".holes[1]", outside(0));        // across an edge
  refuse(with({box(3, 3, 1, 1)}), name + ".holes[1]", outside(0));        // within
  refuse(with({box(1, 1, 6, 6)}), name + ".holes[1]", outside(0));        // around
  refuse(with({frame.holes[0]}), name + ".holes[1]", outside(0));         // the same
  refuse(with({box(7, 7, 0.5, 0.5), box(7, 7, 0.75, 0.5), box(9, 9, 1, 1)}), name + ".holes[2]", outside(1));
  refuse(with({box(9, 9, 1, 1), {{{0, 0}, {1, 1}}}}), name + ".holes[2]", "at least 3 vertices");
  refuse(with({box(9, 9, 1, 1), {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}}), name + ".holes[2][0]",
         "simple: its edge must not meet edge 2");
  refuse({{{{0, 0}, {8, 0}, {8, 0}, {0, 8}}}, {}}, name + ".outer[1]", "different from vertex 2: drop one of the two");
}

}  // namespace touchstone::proptests
