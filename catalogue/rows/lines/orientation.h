// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/long_draws.h"
#include "catalogue/families/rounded_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/shape/walk.h"
#include "catalogue/signatures/lines/orientation.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/lines/orientation.h"
#include "reference/lines/orientation.h"
#include "robust/batch/orientation.h"
#include "robust/lines/orientation.h"

namespace touchstone::catalogue::rows {

struct orientation : signatures::orientation {
  TOUCHSTONE_STAGED_MODULES(orientation)
  TOUCHSTONE_ARRAYS(orientation)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "16-17",
                                     .question = "On which side of the directed line p0 -> p1 does p lie?",
                                     .kind = Kind::decision,
                                     .fields = {"p0", "p1", "p"},
                                     .answer = "side",
                                     .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("collinear", [](DrawStream& c) -> Question {
      const auto [p0, v] = lattice_line(c);
      return {p0, along(p0, small_integer(c), v), along(p0, small_integer(c), v)};
    });
    add("beside_line", [](DrawStream& c) -> Question {
      const auto [p0, v] = lattice_line(c);
      const Point2d p = along(p0, small_integer(c), v);
      return {p0, along(p0, one_to(c, 8), v), {p.x, p.y + small_integer(c, 1)}};
    });
    add("coincident", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 53), q = lattice_point(c, 53);
      switch (c.below(4)) {
        case 0: return {p, p, p};
        case 1: return {p, p, q};
        case 2: return {p, q, p};
        default: return {p, q, q};
      }
    });
    add("axis_parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 53);
      const double x = integer(c, 53), y = integer(c, 53);
      return c.coin() ? Question{p, {p.x, y}, {p.x, x}} : Question{p, {x, p.y}, {y, p.y}};
    });
    add("rounded_on_line", [](DrawStream& c) -> Question {
      const Point2d p0{ordinary(c), ordinary(c)}, p1{ordinary(c), ordinary(c)};
      return {p0, p1, along(p0, ordinary(c), p1 - p0)};
    });
    add("typed_on_line", [](DrawStream& c) -> Question {
      const double x = typed(c), y = typed(c), k = up_to(c, 3);
      return {{0.0, 0.0}, {k * x, k * y}, {x, y}};
    });
    add("far_ends", [](DrawStream& c) -> Question {
      const auto [p0, v] = lattice_line(c, 26, 8);
      return {p0, along(p0, std::ldexp(1, 18), v), along(p0, -std::ldexp(1, 17), v)};
    });
    add("long_collinear", [](DrawStream& c) -> Question {
      const auto [first, last, between] = long_triple(c);
      return c.coin() ? Question{first, between, last} : Question{first, last, between};
    });
    add("past_half_the_bound", [](DrawStream& c) -> Question {
      const auto [p0, p1, p] = rounded_triple(c, c.coin());
      return c.coin() ? Question{p0, p1, p} : Question{p0, p, p1};
    });
  }

  struct decision {
    static Side robust(const Question& q) {
      return ::touchstone::robust::orientation(std::get<0>(q), std::get<1>(q), std::get<2>(q));
    }
    static Side oracle(const rebound_t<Question, std::int64_t>& q) {
      return ::touchstone::oracle::orientation_side<std::int64_t>(std::get<0>(q), std::get<1>(q), std::get<2>(q));
    }
    static Side oracle(const Question& q) {
      return ::touchstone::oracle::orientation_side(std::get<0>(q), std::get<1>(q), std::get<2>(q));
    }
  };

  /// The classroom example: p0 near (0.5, 0.5) on the line through (12, 12) and (24, 24).
  static Question map_centre() { return {{0.5, 0.5}, {12, 12}, {24, 24}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The line of p0 and p1 as well, which p is near.
  static void draw(Drawing& drawing, const Question& question, const Side&) {
    const auto& [p0, p1, p] = question;
    if (!(p0 == p1)) drawing.figures.push_back({Figure::Kind::line, "", {p0.x, p0.y, p1.x, p1.y}, false});
    catalogue::draw(drawing, "p0", p0, false);
    catalogue::draw(drawing, "p1", p1, false);
    catalogue::draw(drawing, "p", p, false);
  }

  static Hooks<orientation> hooks() {
    return {.map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .reflected = {{"left", "right"}}}};
  }
};

}  // namespace touchstone::catalogue::rows
