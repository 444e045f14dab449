// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/prism_draws.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "catalogue/families/meshes/drawn_cut.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/numbers.h"
#include "catalogue/families/rings.h"
#include "oracle/rings/simple.h"

namespace touchstone::catalogue {
namespace {

/// The ring, where it does not touch itself; else a square.
Polygon2d simple_or_square(Polygon2d ring) {
  if (ring.size() >= 3 && !oracle::ring_defect(oracle::IntegerRing(ring))) return ring;
  return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
}

Polygon2d ring_on_small_lattice(DrawStream& draws) {
  Polygon2d ring;
  for (std::uint64_t left = 4 + draws.below(7); left > 0; --left) {
    const auto x = up_to(draws, 4), y = up_to(draws, 4);
    const Point2d p{x, y};
    if (std::find(ring.vertices.begin(), ring.vertices.end(), p) == ring.vertices.end()) ring.vertices.push_back(p);
  }
  untangle(ring);
  return simple_or_square(ring);
}

Polygon2d ring_in_tenths(DrawStream& draws) {
  Polygon2d ring = ring_on_small_lattice(draws);
  compute(ring.vertices, draws);
  return simple_or_square(ring);
}

/// Above (x, y, slope . (x, y)), as high as that. Exact for integers.
Meshd prism_over(const Polygon2d& ring, const Vector2d& slope, double height, DrawStream& draws) {
  std::vector<Point3d> vertices;
  for (const double z : {0.0, height})
    for (const Point2d& p : ring.vertices) vertices.push_back({p.x, p.y, slope.x * p.x + slope.y * p.y + z});
  const auto count = static_cast<Index>(ring.size());
  std::vector<std::vector<Index>> polygons(2);
  for (Index k = 0; k < count; ++k) {
    const Index next = (k + 1) % count;
    polygons[0].insert(polygons[0].begin(), k), polygons[1].push_back(count + k);
    polygons.push_back({k, next, count + next, count + k});
  }
  for (auto& corners : polygons) {
    const auto first = static_cast<std::ptrdiff_t>(draws.below(corners.size()));
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
  }
  return cut_mesh(std::move(vertices), std::move(polygons), draws);
}

Meshd prism_on_small_lattice(DrawStream& draws) {
  const Polygon2d ring = ring_on_small_lattice(draws);
  return prism_over(ring, {small_integer(draws, 2), small_integer(draws, 2)}, 4, draws);
}

}  // namespace

Meshd drawn_prism(DrawStream& draws) {
  switch (draws.below(8)) {
    case 4: return prism_over(simple_or_square(star_ring(draws)), {1, -1}, 4, draws);
    case 5: return prism_over(simple_or_square(comb_ring(draws)), {0, 0}, 4, draws);
    case 6:
    case 7: return prism_over(ring_in_tenths(draws), {0, 0}, 1, draws);
    default: return prism_on_small_lattice(draws);
  }
}

Meshd two_prisms(DrawStream& draws) {
  const Meshd one = prism_on_small_lattice(draws);
  Meshd other = prism_on_small_lattice(draws);
  const double x = small_integer(draws, 4), y = small_integer(draws, 4), z = 4 * small_integer(draws, 1);
  for (Point3d& p : other.vertices) p = {p.x + x, p.y + y, p.z + z};
  return together(one, other);
}

}  // namespace touchstone::catalogue
