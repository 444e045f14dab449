// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "geometry/polygons.h"

/// Polygons, drawn from a draw stream as exact integers below 2^40; the simplest is a triangle or a square.
namespace touchstone::catalogue {

/// Convex, counter-clockwise, without flat angles: a ring of edges in the order of their directions, perhaps with
/// vertices left out.
Polygon2d convex_ring(DrawStream& draws);

/// Convex, counter-clockwise, without flat angles, its edges a long list (list_draws.h): steeper and steeper,
/// and back by their opposites or by one.
Polygon2d long_convex_ring(DrawStream& draws);

/// Visible in full from one point inside; mostly concave. Simple, counter-clockwise.
Polygon2d star_ring(DrawStream& draws);

/// A comb: teeth of different lengths on a bar, the gaps down to width 1. Simple, counter-clockwise.
Polygon2d comb_ring(DrawStream& draws);

/// One of the three above.
Polygon2d simple_ring(DrawStream& draws);

/// The same ring from another vertex on, or reversed.
Polygon2d turned(Polygon2d ring, DrawStream& draws);

/// One more vertex in the middle of an edge: exactly on it if both ends are even, else moved towards it by rounding to
/// integers.
Polygon2d with_flat_vertex(Polygon2d ring, DrawStream& draws);

/// Each edge in up to four equal parts: turns change only across several flat vertices. Twelve times as large, so that
/// the parts are exact.
Polygon2d with_flat_runs(Polygon2d ring, DrawStream& draws);

/// The points as people type or compute them: in tenths, by steps of 0.1 added up, or rotated by an angle and scaled.
/// Collinear points stay so but for rounding.
void compute(std::vector<Point2d>& points, DrawStream& draws);

/// One vertex twice in a row, or a detour from a vertex and back.
Polygon2d with_repeated_vertex(Polygon2d ring, DrawStream& draws);
Polygon2d with_spike(Polygon2d ring, DrawStream& draws);

/// The first vertex once more at the end, as files write rings; a zero may have the other sign there. Now and then
/// twice more, or of two vertices alone.
Polygon2d closed(Polygon2d ring, DrawStream& draws);

/// A point of an edge, an end or an eighth of the way between: exactly there if the ring's numbers are integers of 40
/// bits.
Point2d on_an_edge(const Polygon2d& ring, DrawStream& draws);

/// A ring that draw_ring(draws) draws, from any vertex on and in either direction, and a point that
/// draw_point(ring, draws) draws.
template <auto draw_ring, auto draw_point>
std::tuple<Polygon2d, Point2d> turned_with_point(DrawStream& draws) {
  const Polygon2d ring = turned(draw_ring(draws), draws);
  return {ring, draw_point(ring, draws)};
}

inline Point2d any_vertex(const Polygon2d& ring, DrawStream& draws) { return ring[draws.below(ring.size())]; }

/// On the line through the ends of an edge.
Point2d on_line_of_an_edge(const Polygon2d& ring, DrawStream& draws);

/// p, or a point at most 2 away from it in each coordinate.
Point2d nudged(const Point2d& p, DrawStream& draws);

inline Point2d near_edge(const Polygon2d& ring, DrawStream& draws) { return nudged(on_an_edge(ring, draws), draws); }

/// Four units along a direction of up to 2^40, at most one wide, and a point on its long edges or near them.
std::tuple<Polygon2d, Point2d> needle_and_point(DrawStream& draws);

/// The second vertex is on the line of its neighbours or near it: its cross product is -1, 0 or 1, of products far
/// beyond 2^53. The others are not flat.
Polygon2d nearly_flat_ring(DrawStream& draws);

/// Flat at three vertices, in numbers that people type.
Polygon2d typed_flat_ring(DrawStream& draws);

/// A triangle with an edge from the origin that rises by the least normal number, and a point on it or near it: every
/// difference in y is subnormal, and lost where such numbers are read as zero.
std::tuple<Polygon2d, Point2d> beside_least_edge(DrawStream& draws);

/// The ring of these vertices with crossings undone by turning parts of it round, as far as 60 turns go.
void untangle(Polygon2d& ring);

}  // namespace touchstone::catalogue
