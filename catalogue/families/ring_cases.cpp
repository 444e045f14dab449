// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/ring_cases.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "catalogue/families/plane_draws.h"

namespace touchstone::catalogue {
namespace {

using Rings = std::tuple<Polygon2d>;

double length(DrawStream& c) {
  const double n = std::fabs(integer(c, 20));
  return n == 0 ? 1 : n;
}

/// Eight times as large, so that halves, quarters and eighths of edges are lattice points.
Polygon2d with_flat_vertices(Polygon2d ring, DrawStream& c) {
  for (Point2d& p : ring.vertices) p = {8 * p.x, 8 * p.y};
  for (std::uint64_t more = 1 + c.below(4); more > 0; --more) ring = with_flat_vertex(ring, c);
  return ring;
}

void exchange_two(Polygon2d& ring, DrawStream& c) {
  const std::size_t one = c.below(ring.size()), other = c.below(ring.size());
  std::swap(ring.vertices[one], ring.vertices[other]);
}

/// A rectangle, or one with a corner taken out, with every lattice point of its boundary as a vertex.
Polygon2d lattice_boundary(DrawStream& c) {
  const auto a = static_cast<int>(1 + c.below(5)), b = static_cast<int>(1 + c.below(5));
  const bool notched = c.coin();
  std::vector<Point2d> corners{{0, 0}, {2.0 * a, 0}, {2.0 * a, 1.0 * b}};
  if (notched) corners.insert(corners.end(), {{1.0 * a, 1.0 * b}, {1.0 * a, 2.0 * b}});
  else corners.push_back({2.0 * a, 2.0 * b});
  corners.push_back({0, 2.0 * b});
  Polygon2d ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Point2d p = corners[i];
    const Point2d q = corners[(i + 1) % corners.size()];
    const Vector2d step{static_cast<double>((q.x > p.x) - (q.x < p.x)), static_cast<double>((q.y > p.y) - (q.y < p.y))};
    for (; !(p == q); p = p + step) ring.vertices.push_back(p);
  }
  return ring;
}

/// Two chains that go on in x, one unit apart.
Polygon2d strip(DrawStream& c) {
  std::vector<Point2d> lower;
  double x = 0;
  for (std::uint64_t more = 2 + c.below(8); more > 0; --more) {
    lower.push_back({x, small_integer(c)});
    x += length(c);
  }
  Polygon2d ring{lower};
  for (auto p = lower.rbegin(); p != lower.rend(); ++p) ring.vertices.push_back({p->x, p->y + 1});
  return ring;
}

/// A corridor of width 1 with walls of thickness 1, winding outwards.
Polygon2d spiral(DrawStream& c) {
  static constexpr Vector2d turn[4]{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<Point2d> outer{{0, 0}}, inner{{0, 1}};
  const std::uint64_t arms = 2 + c.below(14);
  for (std::uint64_t k = 0; k < arms; ++k) {
    const Vector2d& v = turn[k % 4];
    outer.push_back(outer.back() + static_cast<double>(3 + 2 * (k / 2)) * v);
    const Vector2d left = turn[(k + 1) % 4], then = k + 1 < arms ? turn[(k + 2) % 4] : Vector2d{0, 0};
    inner.push_back(outer.back() + Vector2d{left.x + then.x, left.y + then.y});
  }
  Polygon2d ring{outer};
  ring.vertices.insert(ring.vertices.end(), inner.rbegin(), inner.rend());
  return ring;
}

/// A frame that closes but for a slit of one unit: a hole, almost.
Polygon2d slit_frame(DrawStream& c) {
  const double a = 4 + length(c), b = 4 + length(c);
  return {{{0, 0}, {a, 0}, {a, b}, {0, b}, {0, 2}, {1, 2}, {1, b - 1}, {a - 1, b - 1}, {a - 1, 1}, {0, 1}}};
}

/// Corners as people type them, 1e6 + 0.1 and tenths around it.
Polygon2d typed_ring(DrawStream& c) {
  const double where = c.coin() ? 1e6 + 0.1 : 0.1;
  Polygon2d ring = c.coin() ? comb_ring(c) : star_ring(c);
  for (Point2d& p : ring.vertices) p = {where + p.x / 10, where + p.y / 10};
  return ring;
}

/// A saw of up to 200 vertices, its teeth leaning to either side.
Polygon2d long_ring(DrawStream& c) {
  const std::uint64_t teeth = c.one_in(12) ? 60 + c.below(39) : 2 + c.below(16);
  Polygon2d ring;
  for (std::uint64_t i = 0; i < teeth; ++i) {
    const double x = 4 * static_cast<double>(i), lean = small_integer(c, 1);
    ring.vertices.insert(ring.vertices.end(), {{x, 0}, {x + 2 + lean, 3 + 8 * (1 + static_cast<double>(i % 3))}});
  }
  ring.vertices.insert(ring.vertices.end(),
                       {{4.0 * static_cast<double>(teeth), 0}, {4.0 * static_cast<double>(teeth), -3}, {0, -3}});
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  return ring;
}

/// Small and in no order, its crossings undone.
Polygon2d untangled(DrawStream& c) {
  Polygon2d ring;
  for (std::uint64_t more = 4 + c.below(6); more > 0; --more) {
    const double x = up_to(c, 6);
    ring.vertices.push_back({x, up_to(c, 6)});
  }
  untangle(ring);
  return ring;
}

/// Edges that become neighbours of a sweep only when two others end; they cross in the one ring, and in the other
/// nothing does.
Rings late_neighbours(DrawStream& c) {
  if (!c.coin()) return turned({{{0, 0}, {10, 10}, {10, 1}, {0, 8}, {1, 4}}}, c);
  return turned({{{0, 0}, {1, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 2}, {2, 1}, {1, 0}}}, c);
}

/// Chains of a sweep that grow at one end and at once at the other.
Rings growing_chains(DrawStream& c) {
  if (!c.coin()) return turned({{{0, 2}, {2, 3}, {5, 6}, {4, 4}, {6, 1}}}, c);
  return turned({{{0, 1}, {3, 2}, {2, 1}, {3, 0}, {1, 1}}}, c);
}

/// A chain of a sweep that splits at its end; sides of pieces that are tested twice.
Rings split_chain(DrawStream& c) {
  if (!c.coin()) return turned({{{2, 0}, {1, 2}, {1, 3}, {0, 1}, {2, 6}, {4, 3}, {2, 2}, {5, 0}}}, c);
  return turned({{{8.000000000000002, 0}, {8, 4}, {8, 8}, {0, 0}, {1, 0}, {2, 0}, {4, 0}}}, c);
}

/// A spike, a vertex twice, a hole that touches its outline in one point, an edge that crosses another; or nothing of
/// these.
Polygon2d defective(DrawStream& c) {
  switch (c.below(6)) {
    case 1: return with_repeated_vertex(simple_ring(c), c);
    case 2: return with_spike(simple_ring(c), c);
    case 3: {
      const double a = length(c);
      return {{{0, 0}, {4 * a, 0}, {4 * a, 4 * a}, {0, 4 * a}, {0, 0}, {a, 2 * a}, {2 * a, a}}};
    }
    case 4: {
      Polygon2d ring = simple_ring(c);
      exchange_two(ring, c);
      return ring;
    }
    case 5: {  // a vertex on another edge
      Polygon2d ring = with_flat_vertices(simple_ring(c), c);
      exchange_two(ring, c);
      return ring;
    }
    default: return simple_ring(c);
  }
}

template <Polygon2d (*Ring)(DrawStream&)>
Rings turned_ring(DrawStream& c) {
  Polygon2d ring = Ring(c);
  if (c.coin()) {
    for (Point2d& p : ring.vertices) std::swap(p.x, p.y);
  }
  return {turned(ring, c)};
}

Polygon2d flat_vertices(DrawStream& c) { return with_flat_vertices(simple_ring(c), c); }

Rings closed_ring(DrawStream& c) {
  const Polygon2d ring = c.coin() ? flat_vertices(c) : simple_ring(c);
  return {closed(turned(ring, c), c)};
}

/// Flat but for rounding, in many places.
Polygon2d computed(DrawStream& c) {
  Polygon2d ring = !c.coin() ? lattice_boundary(c) : c.coin() ? flat_vertices(c) : strip(c);
  compute(ring.vertices, c);
  return ring;
}

}  // namespace

void simple_ring_cases(HardCases<std::tuple<Polygon2d>>& add) {
  add("convex", turned_ring<convex_ring>);
  add("star", turned_ring<star_ring>);
  add("comb", turned_ring<comb_ring>);
  add("flat_vertices", turned_ring<flat_vertices>);
  add("lattice_boundary", turned_ring<lattice_boundary>);
  add("strip", turned_ring<strip>);
  add("spiral", turned_ring<spiral>);
  add("slit_frame", turned_ring<slit_frame>);
  add("typed_ring", turned_ring<typed_ring>);
  add("long", turned_ring<long_ring>);
  add("untangled", turned_ring<untangled>);
  add("late_neighbours", late_neighbours);
  add("growing_chains", growing_chains);
  add("split_chain", split_chain);
  add("defective", turned_ring<defective>);
  add("computed", turned_ring<computed>);
  add("closed_ring", closed_ring);
}

}  // namespace touchstone::catalogue
