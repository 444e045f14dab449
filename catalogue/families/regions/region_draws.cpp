// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/regions/region_draws.h"

#include <algorithm>

#include "catalogue/families/plane_draws.h"
#include "catalogue/families/rings.h"
#include "geometry/invalid_input.h"
#include "oracle/rings/region.h"

namespace touchstone::catalogue {
namespace {

bool valid(const Region2d& region) {
  try {
    validation::validate_numbers("", region);
    oracle::validated_regions<double>({{"", &region}}, Point2d{0, 0});
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

template <class Call>
void each_ring(Region2d& region, const Call& call) {
  call(region.outer);
  for (Polygon2d& hole : region.holes) call(hole);
}

Polygon2d enlarged(Polygon2d ring, double by) {
  for (Point2d& p : ring.vertices) p = {by * p.x, by * p.y};
  return ring;
}

/// From a point between two vertices towards two others; or the outer ring, smaller, around that point.
Polygon2d tentative_hole(const Region2d& region, DrawStream& c) {
  const auto vertex = [&] { return any_vertex(any_ring(region, c), c); };
  const Point2d from = vertex(), to = vertex();
  const Point2d p = along(from, up_to(c, 8) / 8, to - from);
  if (c.one_in(4)) {
    Polygon2d hole = region.outer;
    for (Point2d& q : hole.vertices) q = along(p, 0.125, q - p);
    return hole;
  }
  const Point2d one = vertex(), other = vertex();
  const double s = one_to(c, 6) / 8, t = one_to(c, 6) / 8;
  return {{p, along(p, s, one - p), along(p, t, other - p)}};
}

Polygon2d square(double x, double y, double size) {
  return {{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}};
}

}  // namespace

const Polygon2d& any_ring(const Region2d& region, DrawStream& draws) {
  const std::size_t i = draws.below(region.holes.size() + 1);
  return i == 0 ? region.outer : region.holes[i - 1];
}

Point2d on_an_edge_of(const Region2d& region, DrawStream& draws) {
  const Polygon2d& ring = any_ring(region, draws);
  return on_an_edge(ring, draws);
}

Region2d region(DrawStream& draws) {
  Region2d made{enlarged(simple_ring(draws), 64), {}};
  for (std::uint64_t more = draws.below(8); more > 0; --more) {
    made.holes.push_back(tentative_hole(made, draws));
    if (!valid(made)) made.holes.pop_back();
  }
  return made;
}

Region2d region_with_hole(DrawStream& draws) {
  Region2d made = region(draws);
  if (!made.holes.empty()) return made;
  const double size = one_to(draws, 1 << 10);
  return {square(0, 0, 16 * size), {square(4 * size, 4 * size, 8 * size)}};
}

Region2d turned_region(Region2d region, DrawStream& draws) {
  each_ring(region, [&draws](Polygon2d& ring) { ring = turned(ring, draws); });
  if (!region.holes.empty())
    std::rotate(region.holes.begin(),
                region.holes.begin() + static_cast<std::ptrdiff_t>(draws.below(region.holes.size())),
                region.holes.end());
  return region;
}

Region2d fitting_or_not(DrawStream& draws) {
  const auto triangle = [](const Point2d& p, const Point2d& q, const Point2d& r) { return Polygon2d{{p, q, r}}; };
  const double at = up_to(draws, 8), size = one_to(draws, 8);
  Region2d made{square(0, 0, 8), {}};
  switch (draws.below(8)) {
    case 0: made.holes = {square(at, 1, size)}; break;                                 // within, on an edge, across it
    case 1: made.holes = {triangle({0, 4}, {size, at}, {4, 1})}; break;                // a vertex on an edge, or beyond
    case 2: made.holes = {square(2, 2, 3), square(at - 1, at - 2, size)}; break;       // apart, nested, crossing
    case 3: made.holes = {square(1, 1, 3), square(4, at, 2)}; break;                   // a corner, a piece of an edge
    case 4: made.holes = {square(2, 2, 2), square(1, 1, size), square(2, 2, 2)}; break;  // the same twice, one around
    case 5: made.holes = {triangle({0, 0}, {8, 8}, {at, size})}; break;                // between two corners
    case 6: made.holes = {square(1, 1, 1), square(at + 1, 9, size)}; break;            // outside
    default: made.holes = {square(1, 1, 2), triangle({3, at / 2}, {6, 1}, {6, size})};  // a vertex on an edge of a hole
  }
  if (draws.coin()) std::reverse(made.holes.begin(), made.holes.end());
  return turned_region(std::move(made), draws);
}

Region2d with_defective_ring(DrawStream& draws) {
  Region2d made = region_with_hole(draws);
  const std::size_t i = draws.below(made.holes.size() + 1);
  Polygon2d& ring = i == 0 ? made.outer : made.holes[i - 1];
  switch (draws.below(4)) {
    case 0: ring = closed(ring, draws); break;
    case 1: ring = with_repeated_vertex(ring, draws); break;
    case 2: ring = with_spike(ring, draws); break;
    default: std::swap(ring.vertices[0], ring.vertices[ring.size() / 2]);
  }
  return made;
}

Region2d lattice_of_holes(DrawStream& draws) {
  const auto columns = 1 + draws.below(7), rows = 1 + draws.below(7);
  Region2d made{{{{0, 0}, {16, 0}, {16, 16}, {0, 16}}}, {}};
  for (std::uint64_t i = 0; i < columns; ++i)
    for (std::uint64_t j = 0; j < rows; ++j) {
      const double x = 2 + 2 * static_cast<double>(i), y = 2 + 2 * static_cast<double>(j);
      made.holes.push_back({{{x - 1, y}, {x, y - 1}, {x + 1, y}, {x, y + 1}}});
    }
  return turned_region(std::move(made), draws);
}

Region2d computed_region(DrawStream& draws) {
  Region2d made = region_with_hole(draws);
  std::vector<Point2d> points;
  each_ring(made, [&](const Polygon2d& ring) {
    points.insert(points.end(), ring.vertices.begin(), ring.vertices.end());
  });
  compute(points, draws);
  auto next = points.begin();
  each_ring(made, [&next](Polygon2d& ring) {
    for (Point2d& p : ring.vertices) p = *next++;
  });
  return made;
}

std::pair<Region2d, Region2d> holes_at_crossings(DrawStream& draws) {
  const double in_a = one_to(draws, 7), in_b = one_to(draws, 7);
  const Region2d a{{{{-8, 0}, {8, 0}, {8, 8}, {-8, 8}}}, {{{{0, 0}, {in_a, 4}, {0, 8}, {-6, 4}}}}};
  const Region2d b{{{{0, -8}, {16, -8}, {16, 16}, {0, 16}}}, {{{{0, 0}, {10, -4}, {10, 12}, {0, 8}, {in_b, 4}}}}};
  if (draws.coin()) return {turned_region(b, draws), a};
  return {a, turned_region(b, draws)};
}

void untangle(Region2d& region) {
  each_ring(region, [](Polygon2d& ring) { untangle(ring); });
  std::vector<Polygon2d> given;
  std::swap(given, region.holes);
  for (Polygon2d& hole : given) {
    region.holes.push_back(std::move(hole));
    if (!valid(region)) region.holes.pop_back();
  }
}

}  // namespace touchstone::catalogue
