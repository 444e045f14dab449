// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/kdop_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/kdop_kdop.h"
#include "oracle/volumes/kdop_kdop.h"
#include "reference/volumes/kdop_kdop.h"
#include "robust/volumes/kdop_kdop.h"

namespace touchstone::catalogue::rows {

struct kdop_kdop : signatures::kdop_kdop {
  TOUCHSTONE_STAGED_MODULES(kdop_kdop)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "43",
      .question = "Do the two k-DOPs with the same normals overlap, only touch, or neither, slab by slab?",
      .kind = Kind::decision,
      .fields = {"a", "b"},
      .answer = "contact",
      .time = grows(Growth::linear),
      .list_length = 1};

  static void hard_cases(HardCases<Question>& add) {
    add("side_by_side",
        [](DrawStream& c) -> Question { return pair_of(c, [](DrawStream& d) { return beside(d, 0); }); });
    add("a_gap",
        [](DrawStream& c) -> Question { return pair_of(c, [](DrawStream& d) { return beside(d, up_to(d, 2)); }); });
    add("overlapping", [](DrawStream& c) -> Question { return pair_of(c, overlap); });
    add("flat_within", [](DrawStream& c) -> Question {
      return pair_of(c, [](DrawStream& d) {
        auto [s, t] = overlap(d);
        if (d.coin()) t.min = t.max = s.min + one_to(d, 3);
        return d.coin() ? Pair{t, s} : Pair{s, t};
      });
    });
    add("both_flat", [](DrawStream& c) -> Question {
      return pair_of(c, [](DrawStream& d) {
        const double s = integer(d, 53), t = d.one_in(4) ? s + small_integer(d, 1) : s;
        return Pair{{s, s}, {t, t}};
      });
    });
    add("subnormal", [](DrawStream& c) -> Question {
      return pair_of(c, [](DrawStream& d) {
        const double p = subnormal(d, 3), q = subnormal(d, 3), r = subnormal(d, 3), s = subnormal(d, 3);
        return Pair{{std::min(p, q), std::max(p, q)}, {std::min(r, s), std::max(r, s)}};
      });
    });
    add("either_zero", [](DrawStream& c) -> Question {
      return pair_of(c, [](DrawStream& d) {
        const double p = zero(d), q = zero(d), width = up_to(d, 1);
        return Pair{{-width, p}, {q, 1}};
      });
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return pair_of(c, [](DrawStream& d) {
        const double x = d.coin() ? greatest_double : 0x1p1000;
        return Pair{{-greatest_double, x}, {d.coin() ? x : -x, greatest_double}};
      });
    });
    add("other_normals", [](DrawStream& c) -> Question {
      auto [a, b] = pair_of(c, overlap);
      Vector3d& n = b.normals[c.below(b.normals.size())];
      switch (c.below(6)) {
        case 0: break;
        case 1: n.z = n.z == 0 ? -0.0 : moved_by_ulps(n.z, 1); break;
        case 2: n = {2 * n.x, 2 * n.y, 2 * n.z}; break;
        case 3: b.normals.pop_back(), b.slabs.pop_back(); break;
        case 4: n.y = n.y == 0 ? 0x1p-1074 : n.y; break;
        default: std::reverse(b.normals.begin(), b.normals.end());
      }
      return {a, b};
    });
    add("not_valid", [](DrawStream& c) -> Question {
      auto [a, b] = pair_of(c, [](DrawStream& d) { return beside(d, 1); });
      const std::size_t i = c.below(a.slabs.size());
      switch (c.below(4)) {
        case 0: break;
        case 1: a.normals[i] = b.normals[i] = {0.0, -0.0, 0.0}; break;
        case 2: b.slabs[i] = {b.slabs[i].max, b.slabs[i].min}; break;
        default: a.slabs.pop_back();
      }
      return {a, b};
    });
    add.unscaled("many_slabs", [](DrawStream& c) -> Question {
      // All of them overlap but for one, perhaps.
      Kdop3d a{many_normals(c), {}}, b{a.normals, {}};
      while (a.slabs.size() < a.normals.size()) {
        const auto [s, t] = overlap(c);
        a.slabs.push_back(s), b.slabs.push_back(t);
      }
      const std::size_t place = late_index(a.slabs.size(), c);
      std::tie(a.slabs[place], b.slabs[place]) = beside(c, up_to(c, 2));
      return {a, b};
    });
  }

  /// The normals of a for both.
  static void repair(Question& question) {
    auto& [a, b] = question;
    catalogue::repair(a);
    b.normals = a.normals, b.slabs.resize(b.normals.size());
    catalogue::repair(b);
  }

  /// Normals have no unit: they keep their values.
  static void scale(Question& question, int k) {
    for (Kdop3d* kdop : {&std::get<0>(question), &std::get<1>(question)})
      for (Slabd& slab : kdop->slabs) slab = {std::ldexp(slab.min, k), std::ldexp(slab.max, k)};
  }

  /// The slabs of x touch at 4, those of x + y overlap: moves the ends of the first pair that touch.
  static Question map_centre() {
    const std::vector<Vector3d> normals{{1, 0, 0}, {1, 1, 0}};
    return {{normals, {{0, 4}, {0, 8}}}, {normals, {{4, 9}, {5, 9}}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {7, 16}; }

  static Hooks<kdop_kdop> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  using Pair = std::pair<Slabd, Slabd>;

  /// Pairs of slabs one after another. slabs(draws)
  template <class DrawSlabs>
  static Question pair_of(DrawStream& c, const DrawSlabs& slabs) {
    Kdop3d b;
    const Kdop3d a = kdop_of(c, kdop_normal, [&](DrawStream& d, const Vector3d& n) {
      const auto [s, t] = slabs(d);
      b.normals.push_back(n), b.slabs.push_back(t);
      return s;
    });
    return {a, b};
  }

  static double width(DrawStream& c) { return one_to(c, 8); }
  /// One ends where the other begins, or with a gap; every other pair overlaps.
  static Pair beside(DrawStream& c, double gap) {
    if (c.coin()) return overlap(c);
    const double from = integer(c, 50), s = width(c), t = width(c);
    const Slabd first{from, from + s}, second{from + s + gap, from + s + gap + t};
    return c.coin() ? Pair{second, first} : Pair{first, second};
  }
  static Pair overlap(DrawStream& c) {
    const double from = integer(c, 50), s = 1 + width(c), t = 1 + width(c), into = one_to(c, 2);
    return {{from, from + s}, {from + s - into, from + s - into + t}};
  }
};

}  // namespace touchstone::catalogue::rows
