// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/hard_case.h"
#include "catalogue/families/obb_draws.h"

/// Hard cases of two oriented boxes.
namespace touchstone::catalogue {

using ObbPair = std::tuple<Obb3d, Obb3d>;

inline ObbPair touching_obbs(DrawStream& c, HalfAxes3d (*half_axes)(DrawStream&)) {
  ObbPair q{{lattice_point_in_space(c, 20), half_axes(c)}, {{}, half_axes(c)}};
  const std::size_t i = c.below(6), j = c.below(5);
  bring_to_touch(std::get<0>(q), std::get<1>(q), i, j < i ? j : j + 1, c);
  return q;
}

/// Calls add(name, draw) for each.
template <class Add>
void add_pairs_of_obbs(const Add& add) {
  add("touching", [](DrawStream& c) -> ObbPair { return touching_obbs(c, lattice_half_axes); });
  add("orthogonal_touching", [](DrawStream& c) -> ObbPair {
    return touching_obbs(c, [](DrawStream& d) { return d.coin() ? turned_half_axes(d) : straight_half_axes(d); });
  });
  add("crossing_edges", [](DrawStream& c) -> ObbPair {
    // Boxes that only an axis of two edges separates, or none.
    ObbPair q{lattice_obb(c), {{}, lattice_half_axes(c)}};
    auto& [a, b] = q;
    const std::size_t i = c.below(3), j = 3 + c.below(3);
    bring_to_touch(a, b, i, j, c);
    b.center.x += small_integer(c, 1);
    return q;
  });
  add("near_touch", [](DrawStream& c) -> ObbPair {
    ObbPair q = touching_obbs(c, [](DrawStream& d) { return skew_half_axes(d, 20); });
    Point3d& center = std::get<1>(q).center;
    center = beside(center, c);
    return q;
  });
  add("nearly_dependent", [](DrawStream& c) -> ObbPair {
    ObbPair q = touching_obbs(c, slanted_half_axes);
    Point3d& center = std::get<1>(q).center;
    center = beside(center, c);
    return q;
  });
  add("parallel", [](DrawStream& c) -> ObbPair {
    // The same half axes in any order, of any length: side by side, nested, the same box.
    const Obb3d a = lattice_obb(c);
    return {a, alike(a, c)};
  });
  add("nearly_parallel", [](DrawStream& c) -> ObbPair {
    const Obb3d a = lattice_obb(c);
    Obb3d b = alike(a, c);
    for (Vector3d* axis : each_of(b.half_axes)) *axis = beside(*axis, c);
    return {a, b};
  });
  add("ridges", [](DrawStream& c) -> ObbPair {
    // One roof upside down on another: the ridges cross at an angle of a few times the least number, or are one.
    const auto slope = [&c] { return one_to(c, 3); };
    const double p = slope(), q = slope(), r = slope(), s = slope(), y = subnormal(c, 2), z = small_integer(c, 1);
    const HalfAxes3d roof{{4, 0, 0}, {0, p, q}, {0, -1, 1}}, other{{4, y, 0}, {0, r, s}, {0, -1, 1}};
    return {{{0, 0, 0}, roof}, {{0, 0, 2 + q + s + z}, other}};
  });
  add("dependent", [](DrawStream& c) -> ObbPair {
    const Vector3d u = lattice_normal(c), v = lattice_normal(c);
    const double r = small_integer(c), s = small_integer(c);
    const Obb3d flat{lattice_point_in_space(c, 20), {u, r * u + s * v, v}}, other = lattice_obb(c);
    return in_either_order(c, other, flat);
  });
  add("stretched", [](DrawStream& c) -> ObbPair {
    ObbPair q = touching_obbs(c, lattice_half_axes);
    Stretch{c, {0, 60, 255, -170, 300, -300, -355}}(std::get<0>(q), std::get<1>(q));
    return q;
  });
  add("long_and_thin", [](DrawStream& c) -> ObbPair {
    const Obb3d a = long_and_thin_obb(c);
    const double r = small_integer(c, 6);
    switch (c.below(3)) {
      case 0: return {a, {halves_along(a, r, 0, 0), a.half_axes}};
      case 1: return {a, {halves_along(a, 0, r, 0), a.half_axes}};
      default: return {a, {halves_along(a, 0, 0, r), a.half_axes}};
    }
  });
  add("rounded_touch", [](DrawStream& c) -> ObbPair { return touching_obbs(c, ordinary_half_axes); });
  add("terms_below_least", [](DrawStream& c) -> ObbPair {
    // Products of three coordinates are a few times the least number, or less.
    ObbPair q = touching_obbs(c, lattice_half_axes);
    auto& [a, b] = q;
    b.center = {b.center.x - a.center.x, b.center.y - a.center.y, b.center.z - a.center.z};
    a.center = {0, 0, 0};
    const int k = -350 - integer_in(c, 0, 15);
    for (Obb3d* box : {&a, &b}) change_each(*box, [k](auto& v) { v = scaled(v, k); });
    return q;
  });
  add("whole_range", [](DrawStream& c) -> ObbPair {
    // The way from one center to the other is beyond the range.
    const auto part = [&c] { return std::ldexp(static_cast<double>(4 + c.below(4)), 1021); };
    const double x = part(), y = part(), r = part(), far = small_integer(c, 1), s = x + (y - r);
    return {{{-x, 0, 0}, {{r, 0, 0}, {far * x, y, 0}, {0, 0, 1}}},
            {{y, 0, 0}, {{s, 0, 0}, {0, y, 0}, {far * y, 0, 1}}}};
  });
  add("either_zero", [](DrawStream& c) -> ObbPair {
    const Obb3d a{{zero(c), zero(c), zero(c)}, {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}};
    const double x = small_integer(c, 2), y = small_integer(c, 2);
    return {
        a, {{x == 0 ? zero(c) : x, y, zero(c)}, {{zero(c), 1, zero(c)}, {1, zero(c), zero(c)}, {zero(c), zero(c), 1}}}};
  });
  add("typed_touch", [](DrawStream& c) -> ObbPair {
    // As typed they touch.
    const double k = one_to(c, 9), m = one_to(c, 9);
    return {{{0, 0, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}},
            {{3 * (k + m) / 10, 4 * (k + m) / 10, 0}, {{3 * m / 10, 4 * m / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}};
  });
  add("beams_on_edge", [](DrawStream& c) -> ObbPair { return beams_on_edge(c); });
  add("apart_by_face_of_a", [](DrawStream& c) -> ObbPair {
    const std::size_t third = c.below(3);
    return apart_on_one_axis(third == 0 ? 1 : 0, third == 2 ? 1 : 2, c);
  });
  add("apart_by_face_of_b", [](DrawStream& c) -> ObbPair {
    const std::size_t third = c.below(3);
    return apart_on_one_axis(third == 0 ? 4 : 3, third == 2 ? 4 : 5, c);
  });
  add("apart_by_edges_u_u", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(0, 3, c); });
  add("apart_by_edges_u_v", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(0, 4, c); });
  add("apart_by_edges_u_w", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(0, 5, c); });
  add("apart_by_edges_v_u", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(1, 3, c); });
  add("apart_by_edges_v_v", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(1, 4, c); });
  add("apart_by_edges_v_w", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(1, 5, c); });
  add("apart_by_edges_w_u", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(2, 3, c); });
  add("apart_by_edges_w_v", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(2, 4, c); });
  add("apart_by_edges_w_w", [](DrawStream& c) -> ObbPair { return apart_on_one_axis(2, 5, c); });
}

}  // namespace touchstone::catalogue
