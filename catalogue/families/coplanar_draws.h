// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "catalogue/families/triangle_draws.h"

/// Shapes in the plane of a triangle, drawn from a draw stream.
namespace touchstone::catalogue {

/// A triangle with the corners (0, 0), (12, 0) and (0, 12) in integer coordinates of its plane, which is across an axis
/// or any of the lattice; and segments and triangles of that plane, which touch it, pass it by one unit, cross it or
/// lie within. A statement about one edge or corner holds for each, because corners are listed in any order.
class CoplanarDraws {
 public:
  explicit CoplanarDraws(DrawStream& draws) : draws_(draws), plane_(LatticePlane::of(draws, 6)) {
    static constexpr std::array<Vector3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const std::size_t axis = draws.below(3), next = axis + 1 + draws.below(2);
    if (!draws.coin()) plane_.u = axes[axis], plane_.v = axes[next % 3];
  }

  Triangle3d triangle() { return in_some_order({plane_.at(0, 0), plane_.at(12, 0), plane_.at(0, 12)}, draws_); }

  /// A corner, or an end, on an edge or one unit from it, inside or outside; the rest is outside of that edge.
  Triangle3d triangle_at_edge() { return triangle_of({at_edge(), {any(), -out()}, {any(), -out()}}); }
  Segment3d segment_at_edge() { return segment_of({at_edge(), {any(), -out()}}); }

  /// No point outside; seldom one on the boundary.
  Triangle3d triangle_within() { return triangle_of({within(), within(), within()}); }
  Segment3d segment_within() { return segment_of({within(), within()}); }

  Triangle3d other_triangle() {
    const double i = on_edge(), j = small_integer(draws_, 1);
    switch (draws_.below(5)) {
      case 0: return triangle_of({{8 + j, 8}, {8, -4}, {-4, 8 + j}});                   // no corner is inside the other
      case 1: return triangle_of({{any(), 0}, {any(), 0}, {any(), any()}});             // an edge along an edge
      case 2: return triangle_of({{0, 0}, {-out(), any()}, {any(), -out()}});           // a common corner
      case 3: return triangle_of({{-out(), on_edge()}, {-out(), i}, {12 + out(), i}});  // from one side to another
      default: return triangle_of({{any(), any()}, {any(), any()}, {any(), any()}});
    }
  }
  Segment3d segment() {
    const double i = on_edge(), j = small_integer(draws_, 1);
    switch (draws_.below(5)) {
      case 0: return segment_of({{i, -out()}, {-out(), on_edge()}});  // across two edges, or past their corner
      case 1: return segment_of({{any(), j}, {any(), j}});            // along an edge, or one unit from it
      case 2: {                                                       // at a corner, or one unit from it
        const double x = out(), y = out(), more = one_to(draws_, 3);
        return segment_of({{x + j, -y}, {-more * x + j, more * y}});
      }
      case 3: return segment_of({{0, 0}, {any(), any()}});  // from a corner
      default: return segment_of({{any(), any()}, {any(), any()}});
    }
  }

 private:
  struct Place {
    double i, j;
  };
  struct Ends {
    Place a, b;
  };
  struct Corners {
    Place a, b, c;
  };

  double on_edge() { return one_to(draws_, 11); }
  double out() { return one_to(draws_, 12); }
  double any() { return small_integer(draws_, 20); }
  Place at_edge() {
    const double i = on_edge();
    return {i, std::array{0.0, 0.0, -1.0, 1.0}[draws_.below(4)]};
  }
  Place within() {
    const std::uint64_t boundary = draws_.one_in(8) ? 1 : 0;
    const std::uint64_t i = 1 - boundary + draws_.below(10 + 3 * boundary);
    return {static_cast<double>(i), static_cast<double>(1 - boundary + draws_.below(11 + 2 * boundary - i))};
  }
  Point3d at(const Place& place) const { return plane_.at(place.i, place.j); }
  Segment3d segment_of(const Ends& p) {
    return draws_.coin() ? Segment3d{at(p.b), at(p.a)} : Segment3d{at(p.a), at(p.b)};
  }
  Triangle3d triangle_of(const Corners& p) { return in_some_order({at(p.a), at(p.b), at(p.c)}, draws_); }

  DrawStream& draws_;
  LatticePlane plane_;
};

}  // namespace touchstone::catalogue
