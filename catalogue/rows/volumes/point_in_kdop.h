// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/kdop_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/point_in_kdop.h"
#include "oracle/volumes/point_in_kdop.h"
#include "reference/volumes/point_in_kdop.h"
#include "robust/volumes/point_in_kdop.h"

namespace touchstone::catalogue::rows {

struct point_in_kdop : signatures::point_in_kdop {
  TOUCHSTONE_STAGED_MODULES(point_in_kdop)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "43",
      .question = "Does the point lie inside the k-DOP, at the end of a slab, or outside?",
      .kind = Kind::decision,
      .fields = {"kdop", "point"},
      .answer = "location",
      .margin_degree = 2,
      .time = grows(Growth::linear),
      .list_length = 1};

  static void hard_cases(HardCases<Question>& add) {
    add("around", [](DrawStream& c) -> Question {
      return on_lattice(c, kdop_normal, [](DrawStream& d, double value) {
        const double below = up_to(d, 7), above = up_to(d, 7);
        return Slabd{value - below, value + above};
      });
    });
    add("beside_an_end", [](DrawStream& c) -> Question {
      return on_lattice(c, kdop_normal, [](DrawStream& d, double value) {
        const double end = value + small_integer(d, 1), other = one_to(d, 8);
        return d.coin() ? Slabd{end, end + other} : Slabd{end - other, end};
      });
    });
    add("flat_slab", [](DrawStream& c) -> Question {
      return on_lattice(c, kdop_normal, [](DrawStream& d, double value) {
        const double end = d.one_in(6) ? value + small_integer(d, 1) : value;
        return d.coin() ? Slabd{end, end} : Slabd{value - 1, value + 1};
      });
    });
    add("no_solid", [](DrawStream& c) -> Question {
      // The same slab of one direction and its opposite, which have nothing in common unless they touch.
      const Vector3d n = lattice_normal(c);
      const Point3d p = lattice_point_in_space(c);
      const double value = product(n, p), gap = up_to(c, 2);
      return {{{n, {-n.x, -n.y, -n.z}}, {{value - 4, value}, {-value - 4 - gap, -value - gap}}}, p};
    });
    add("normals_of_any_size", [](DrawStream& c) -> Question {
      auto [kdop, p] = on_lattice(c, kdop_normal, at_an_end);
      for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
        const int k = integer_in(c, -1050, 949);
        kdop.normals[i] = scaled(kdop.normals[i], k);
        kdop.slabs[i] = {std::ldexp(kdop.slabs[i].min, k), std::ldexp(kdop.slabs[i].max, k)};
      }
      return {kdop, p};
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      const auto [plane, p] = terms_below_least(c);
      const double end = -plane.offset;
      return {{{plane.normal}, {c.coin() ? Slabd{end, 1} : Slabd{-1, end}}}, p};
    });
    add("subnormal_times_huge", [](DrawStream& c) -> Question {
      const double huge = one_to(c, 8), small = one_to(c, 64), end = std::ldexp(huge * small, -531);
      const Vector3d n{std::ldexp(huge, 500), 0, 0};
      return {{{n}, {c.coin() ? Slabd{end, 2 * end} : Slabd{-end, end}}}, {std::ldexp(small, -1030), 0, 0}};
    });
    add("as_wide_as_a_lattice", [](DrawStream& c) -> Question {
      // The terms span about 124 binary digits, from where on their sum does not fit two words.
      const double size = 8 + up_to(c, 7);
      const double x = std::ldexp(size, integer_in(c, 57, 60)), end = c.one_in(4) ? 0.0 : small_integer(c, 1);
      return {{{{x, -x, 1}}, {c.coin() ? Slabd{end, x} : Slabd{-1, end}}}, {x, x, small_integer(c, 1)}};
    });
    add("beyond_range", [](DrawStream& c) -> Question {
      const double x = std::ldexp(one_to(c, 8), 1020), y = either_sign(c) * x;
      return {kdop_of(c, usual_normal,
                      [](DrawStream& d, const Vector3d&) {
                        const double end = std::ldexp(small_integer(d), 1020);
                        return d.coin() ? Slabd{end, greatest_double} : Slabd{-greatest_double, end};
                      }),
              {x, y, x}};
    });
    add("rounded_end", [](DrawStream& c) -> Question { return rounded(c, ordinary); });
    add("typed_end", [](DrawStream& c) -> Question { return rounded(c, typed); });
    add("not_valid", [](DrawStream& c) -> Question {
      auto [kdop, p] = on_lattice(c, kdop_normal, at_an_end);
      const std::size_t i = c.below(kdop.slabs.size());
      switch (c.below(5)) {
        case 0: break;
        case 1: kdop.normals[i] = {0.0, -0.0, 0.0}; break;
        case 2: kdop.slabs[i] = {kdop.slabs[i].max + 1, kdop.slabs[i].min}; break;
        case 3: kdop.slabs.pop_back(); break;
        default: kdop = {};
      }
      return {kdop, p};
    });
    add.unscaled("many_slabs", [](DrawStream& c) -> Question {
      // The point is within all of them but for one, perhaps.
      const Point3d p = lattice_point_in_space(c);
      Kdop3d kdop{many_normals(c), {}};
      for (const Vector3d& n : kdop.normals) {
        const double value = product(n, p), below = one_to(c, 8);
        kdop.slabs.push_back({value - below, value + one_to(c, 8)});
      }
      const std::size_t place = late_index(kdop.slabs.size(), c);
      const double end = product(kdop.normals[place], p) + small_integer(c, 1);
      kdop.slabs[place] = c.coin() ? Slabd{end, end + 8} : Slabd{end - 8, end};
      return {kdop, p};
    });
  }

  static void repair(Question& question) { catalogue::repair(std::get<0>(question)); }

  /// Normals have no unit: they keep their values.
  static void scale(Question& question, int k) {
    auto& [kdop, p] = question;
    for (Slabd& slab : kdop.slabs) slab = {std::ldexp(slab.min, k), std::ldexp(slab.max, k)};
    lengthen(p, k);
  }

  /// The point (1, 1, 1) is at an end of 0 <= x + y + z <= 3 and within the other slab: moves x and y.
  static Question map_centre() { return {{{{1, 1, 1}, {1, 0, 0}}, {{0, 3}, {-4, 4}}}, {1, 1, 1}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {10, 11}; }

  static Hooks<point_in_kdop> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  static Slabd at_an_end(DrawStream& c, double value) {
    const double other = up_to(c, 3);
    return c.coin() ? Slabd{value, value + other} : Slabd{value - other, value};
  }

  /// A lattice point, and slabs that are drawn by N . P. slab(draws, N . P)
  template <class DrawNormal, class DrawSlab>
  static Question on_lattice(DrawStream& c, const DrawNormal& normal, const DrawSlab& slab) {
    const Point3d p = lattice_point_in_space(c);
    return {kdop_of(c, normal, [&](DrawStream& d, const Vector3d& n) { return slab(d, product(n, p)); }), p};
  }

  /// Ends that are N . P as computed.
  template <class DrawNumber>
  static Question rounded(DrawStream& c, const DrawNumber& number) {
    const auto drawn = [&](DrawStream& d) {
      const double x = number(d), y = number(d), z = number(d);
      return Vector3d{x, y, z == 0 ? 1 : z};
    };
    const Vector3d p = drawn(c);
    const Point3d point{p.x, p.y, p.z};
    return {kdop_of(c, drawn,
                    [&](DrawStream& d, const Vector3d& n) {
                      const double value = product(n, point);
                      return d.coin() ? Slabd{value, value + 1} : Slabd{value - 1, value};
                    }),
            point};
  }
};

}  // namespace touchstone::catalogue::rows
