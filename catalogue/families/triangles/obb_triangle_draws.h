// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/families/triangle_draws.h"

/// Hard cases of triangles that oriented boxes meet.
namespace touchstone::catalogue {

using TriangleAndBox = std::tuple<Triangle3d, Obb3d>;

/// Sides of even integers: half of one is an integer.
struct Sides {
  Vector3d first, second;
  static Sides of(DrawStream& c, int bits = 4) {
    return {2.0 * lattice_normal(c, bits), 2.0 * lattice_normal(c, bits)};
  }
};

/// A triangle that touches a box from outside, as far as the edges number i and j are not parallel, the half axes
/// before the three sides: along the axis at right angles to both. Where the axis leaves it open a point of an edge or
/// a face is touched, and the middle of a side may touch. Exact for small integers.
inline TriangleAndBox brought_to_touch(const Obb3d& box, const Sides& sides, std::size_t i, std::size_t j,
                                       DrawStream& c) {
  const auto& [first, second] = sides;
  const auto& [u, v, w] = box.half_axes;
  const Vector3d edges[] = {u, v, w, first, second, second - first};
  const Vector3d n = cross(edges[i], edges[j]);
  Point3d at = box.center;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = dot(n, edges[k]), open = small_integer(c, 2);
    at = at + (along == 0 ? open : along > 0 ? 2.0 : -2.0) / 2 * edges[k];
  }
  std::array<Vector3d, 3> corners{Vector3d{0, 0, 0}, first, second};
  const auto turn = static_cast<std::ptrdiff_t>(c.below(3));
  std::rotate(corners.begin(), corners.begin() + turn, corners.end());
  std::stable_sort(corners.begin(), corners.end(),
                   [&n](const Vector3d& p, const Vector3d& q) { return dot(n, p) < dot(n, q); });
  const bool level = dot(n, corners[0]) == dot(n, corners[1]);
  const Vector3d lowest = level && c.coin() ? 0.5 * (corners[0] + corners[1]) : corners[0];
  const double off = c.one_in(3) ? small_integer(c, 1) : 0.0;
  const Point3d origin = along(at, off, n);
  const auto corner = [&](std::size_t k) { return origin + (corners[k] - lowest); };
  return {in_some_order({corner(0), corner(1), corner(2)}, c), box};
}
inline TriangleAndBox touching_triangle(DrawStream& c, const HalfAxes3d& half_axes, int bits = 4) {
  const std::size_t i = c.below(6), j = c.below(5);
  const Obb3d box{lattice_point_in_space(c, 16), half_axes};
  return brought_to_touch(box, Sides::of(c, bits), i, j < i ? j : j + 1, c);
}

/// Calls add(name, draw) for each.
template <class Add>
void add_triangles_and_boxes(const Add& add) {
  add("touching", [](DrawStream& c) -> TriangleAndBox { return touching_triangle(c, lattice_half_axes(c)); });
  add("crossing_edges", [](DrawStream& c) -> TriangleAndBox {
    // Only an axis of two edges separates them, or none.
    const std::size_t i = c.below(3), j = 3 + c.below(3);
    const Obb3d box{lattice_point_in_space(c, 16), turned_half_axes(c)};
    return brought_to_touch(box, Sides::of(c), i, j, c);
  });
  add("past_a_corner", [](DrawStream& c) -> TriangleAndBox {
    // So large that nothing but its plane separates them.
    const Obb3d box{lattice_point_in_space(c, 16), turned_half_axes(c)};
    auto [t, other] = brought_to_touch(box, Sides::of(c), 3, 4, c);
    const Point3d middle = t.a;
    const double far = power_of_two(c, 6, 12);
    const auto away = [&](const Point3d& p) { return along(middle, far, p - middle); };
    const Point3d back = along(along(middle, -1, t.b - middle), -1, t.c - middle);
    return {{away(t.b), away(t.c), away(back)}, other};
  });
  add("near_touch", [](DrawStream& c) -> TriangleAndBox {
    auto [t, box] = touching_triangle(c, skew_half_axes(c, 16), 16);
    t.a = beside(t.a, c), t.b = beside(t.b, c);
    return {t, box};
  });
  add("corner_on_boundary", [](DrawStream& c) -> TriangleAndBox {
    // Or inside; the others are anywhere.
    const Obb3d box = lattice_obb(c);
    const Point3d p = c.coin() ? on_obb(box, c) : in_obb(box, c);
    const Point3d q = c.coin() ? on_obb(box, c) : p + 2.0 * lattice_normal(c, 6);
    return {in_some_order({p, q, p + 2.0 * lattice_normal(c, 6)}, c), box};
  });
  add("parallel_to_edges", [](DrawStream& c) -> TriangleAndBox {
    // On the grid of halves of the half axes: in the plane of a face, across, within.
    const Obb3d box = lattice_obb(c);
    const auto on_grid = [&box](DrawStream& d) {
      const double r = small_integer(d, 4), s = small_integer(d, 4);
      return halves_along(box, r, s, small_integer(d, 4));
    };
    return {triangle_of(c, on_grid), box};
  });
  add("in_plane_of_face", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box = lattice_obb(c);
    const double up = c.coin() ? 2 : small_integer(c, 2);
    const auto on_plane = [&box, up](DrawStream& d) {
      const double r = small_integer(d, 9);
      return halves_along(box, r, small_integer(d, 9), up);
    };
    return {triangle_of(c, on_plane), box};
  });
  add("no_area", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box = lattice_obb(c);
    const Point3d p = on_obb(box, c);
    const Vector3d displacement = lattice_normal(c, 6);
    const double i = small_integer(c, 3), j = small_integer(c, 3), k = c.one_in(3) ? i : small_integer(c, 3);
    return {{along(p, i, displacement), along(p, j, displacement), along(p, k, displacement)}, box};
  });
  add("triangle_is_point", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box = lattice_obb(c);
    const Point3d p = c.coin() ? on_obb(box, c) : in_obb(box, c);
    const double aside = small_integer(c, 1);
    const Point3d q{p.x + aside, p.y, p.z};
    return {{q, q, q}, box};
  });
  add("nearly_dependent", [](DrawStream& c) -> TriangleAndBox { return touching_triangle(c, slanted_half_axes(c)); });
  add("dependent", [](DrawStream& c) -> TriangleAndBox {
    const Vector3d u = lattice_normal(c), v = lattice_normal(c);
    const double r = small_integer(c), s = small_integer(c);
    return {triangle_of(c, small_lattice_point), {lattice_point_in_space(c, 20), {u, r * u + s * v, v}}};
  });
  add("needle", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box{{0, 0, 0}, lattice_half_axes(c)};
    return {in_some_order(needle(c, 10, 41), c), box};
  });
  add("stretched", [](DrawStream& c) -> TriangleAndBox {
    auto [t, box] = touching_triangle(c, lattice_half_axes(c));
    Stretch{c, {0, 60, 255, -170, 300, -300, -355}}(t, box);
    return {t, box};
  });
  add("long_and_thin", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box = long_and_thin_obb(c);
    const Point3d p = on_obb(box, c), q = on_obb(box, c);
    return {{p, q, c.coin() ? on_obb(box, c) : lattice_point_in_space(c, 4)}, box};
  });
  add("rounded_touch", [](DrawStream& c) -> TriangleAndBox {
    const Obb3d box{ordinary_point_in_space(c), ordinary_half_axes(c)};
    const std::size_t i = c.below(6), j = c.below(5);
    const auto side = [&c] { return Vector3d{ordinary(c), ordinary(c), ordinary(c)}; };
    const Sides sides{side(), side()};
    return brought_to_touch(box, sides, i, j < i ? j : j + 1, c);
  });
  add("subnormal", [](DrawStream& c) -> TriangleAndBox {
    // Integers times the least number, or a few times that: their products underflow.
    auto [t, box] = touching_triangle(c, skew_half_axes(c));
    const int down = -1074 + integer_in(c, 0, 60);
    const auto change = [down](auto& v) { v = scaled(v, down); };
    change_each(t, change), change_each(box, change);
    return {t, box};
  });
  add("moderate_ends", [](DrawStream& c) -> TriangleAndBox {
    // With the greatest and the least numbers that the filter takes, and the next beyond; near a touch or far from it.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), off = small_integer(c, 1);
    const double x = large + off * (c.coin() ? least : large / 2);
    return {{{x, 0, least}, {x, large, 0}, {2 * large, 1, -least}},
            {{0, 0, 0}, {{large, 0, 0}, {0, 1, least}, {0, 0, 1}}}};
  });
  add("whole_range", [](DrawStream& c) -> TriangleAndBox {
    const double x = huge(c), y = huge(c), far = of_full_range(c);
    return {triangle_of(c, point_of_full_range), {point_of_full_range(c), {{x, 0, 0}, {far, y, 0}, {0, far, 1}}}};
  });
  add("either_zero", [](DrawStream& c) -> TriangleAndBox {
    const Point3d a = zero_point(c), b = zero_point(c), d = zero_point(c);
    const double x = small_integer(c, 2);
    return {{{x == 0 ? zero(c) : x, a.y, a.z}, {1, c.coin() ? b.y : 1, b.z}, {c.coin() ? d.x : 2, -1, d.z}},
            {zero_point(c), {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}}};
  });
  add("typed_touch", [](DrawStream& c) -> TriangleAndBox {
    // As typed a corner is on a face of a box that is turned by the triple 3, 4, 5.
    const double k = one_to(c, 9), m = one_to(c, 9);
    const double x = 3 * (k + m), y = 4 * (k + m);
    return {{{x / 10, y / 10, 0.1}, {(x + 1) / 10, y / 10, 0.3}, {x / 10, (y + 1) / 10, -0.7}},
            {{3 * m / 10, 4 * m / 10, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}};
  });
}

}  // namespace touchstone::catalogue
