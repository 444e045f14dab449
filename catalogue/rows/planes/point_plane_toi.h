// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/draw/side_view.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/point_plane_toi.h"
#include "oracle/planes/point_plane.h"
#include "oracle/planes/point_plane_toi.h"
#include "reference/planes/point_plane_toi.h"
#include "robust/planes/point_plane_toi.h"

namespace touchstone::catalogue::rows {

struct point_plane_toi : signatures::point_plane_toi {
  TOUCHSTONE_STAGED_MODULES(point_plane_toi)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "planes",
      .pages = "23",
      .question =
          "Does a point that moves from start to end hit the plane: at the end of the step, and "
          "first when and where?",
      .kind = Kind::measure,
      .fields = {"plane", "start", "end"},
      .ulps = 17,
      .margin_degree = 2,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add("through", [](DrawStream& c) -> Question {
      const double up = one_to(c, 8), down = one_to(c, 8);
      return step(c, up, -down);
    });
    add("ends_on_plane", [](DrawStream& c) -> Question { return step(c, one_to(c, 8), 0); });
    add("starts_on_plane", [](DrawStream& c) -> Question { return step(c, 0, small_integer(c)); });
    add("starts_behind", [](DrawStream& c) -> Question {
      const double down = one_to(c, 8), then = small_integer(c);
      return step(c, -down, then);
    });
    add("stays_in_front", [](DrawStream& c) -> Question {
      const double up = one_to(c, 8), then = one_to(c, 8);
      return step(c, up, then);
    });
    add("along_plane", [](DrawStream& c) -> Question {
      const double height = small_integer(c, 1);
      return step(c, height, height);
    });
    add("at_rest", [](DrawStream& c) -> Question {
      const double height = small_integer(c, 1);
      const auto [plane, start, end] = step(c, height, 0);
      return {plane, start, start};
    });
    add("long_step", [](DrawStream& c) -> Question {
      const double y = scaled_up(c, 1 << 20, 40);
      const Vector3d n = lattice_normal(c);
      const Point3d start = lattice_point_in_space(c);
      return {{n, integer(c, 30)}, start, start + (-y) * n};
    });
    add("ends_just_past", [](DrawStream& c) -> Question {
      const double far = power_of_two(c, 20, 51), x = integer(c, 26);
      return {{{0, 1, 0}, 0}, {x, far, 0}, {x + small_integer(c), small_integer(c, 1), 1}};
    });
    add("rounded_on_plane", [](DrawStream& c) -> Question {
      const Vector3d n{ordinary(c), ordinary(c), 1 + std::fabs(ordinary(c))}, p{ordinary(c), ordinary(c), ordinary(c)};
      return {{n, -dot(n, p)}, Point3d{p.x, p.y, p.z} + one_to(c, 8) * n, {p.x, p.y, p.z}};
    });
    add("typed_step", [](DrawStream& c) -> Question {
      const double y = std::fabs(typed(c)), d = typed(c);
      return {{{0, 1, 0}, -d}, {typed(c), d + y, 0.3}, {typed(c), d - std::fabs(typed(c)), 0.1}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      // At t = 1/2, a coordinate halfway between two doubles but for one bit, about 64 digits below the first.
      return {{{0, 1, 0}, 0}, {1, 1, 1}, {beside_half_an_ulp(c, -62, 4), -1, 0}};
    });
    add("wide_heights", [](DrawStream& c) -> Question {
      // The heights are sums of two words, but not in one unit.
      const auto wide = [&c](int k) {
        return std::ldexp(0x1p51 + static_cast<double>(c.below(std::uint64_t{1} << 51)), k);
      };
      const double x = wide(20), end = -wide(22);
      return {{{0x1p52 + 1, 0x1p52 + 1, 0x1p-20}, 0}, {x, 0, 0x1p20}, {end, end, -0x1p22}};
    });
    add("last_binade", [](DrawStream& c) -> Question {
      const double x = std::ldexp(16 + up_to(c, 15), 1019), up = one_to(c, 8);
      return {{{0, 1, 0}, 0}, {x, up, 0}, {x, -one_to(c, 8), 0}};
    });
    add("starts_below_least", [](DrawStream& c) -> Question {
      const auto [plane, start] = terms_below_least(c);
      return {plane, start, {1, 1, 1}};
    });
    add("starts_subnormal", [](DrawStream& c) -> Question {
      // A huge normal makes it count.
      const double offset = std::ldexp(one_to(c, 64), -531);
      const double x = std::ldexp(offset, -499);
      return {{{0x1p500, 0, 0}, -offset}, {x, 0, 0}, {-3 * x, 0, 0}};
    });
    add("zero_normal", [](DrawStream& c) -> Question {
      const Vector3d n{0.0, zero(c), 0.0};
      const Point3d start = lattice_point_in_space(c);
      return {{n, small_integer(c)}, start, lattice_point_in_space(c)};
    });
  }

  /// The normal has no unit: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [plane, start, end] = question;
    const auto scaled = [k](const Point3d& p) {
      return Point3d{std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
    };
    plane.offset = std::ldexp(plane.offset, k);
    start = scaled(start), end = scaled(end);
  }

  /// From the side: the plane is a line. Option 1 finds the point at the end of the step, option 2 on the plane.
  static void draw(Drawing& drawing, const Question& question, const PointPlaneToi<double>& truth) {
    const auto& [plane, start, end] = question;
    const Vector3d v = end - start;
    const SideView view = SideView::of(plane, v);
    const auto over = [&plane = plane](const Point3d& p) {
      return nearest(::touchstone::oracle::point_plane(plane, p).answer.signed_distance);
    };
    const Point2d from = view.at({0, 0, 0}, over(start)), to = view.at(v, over(end));
    const double low = std::min(from.x, to.x), high = std::max(from.x, to.x);
    SideView::draw_plane(drawing, low, high, std::max(std::fabs(from.y), std::fabs(to.y)));
    drawing.figures.push_back({Figure::Kind::arrow, "step", {from.x, from.y, to.x, to.y}, false});
    drawing.figures.push_back({Figure::Kind::point, "start", {from.x, from.y}, false});
    drawing.figures.push_back({Figure::Kind::point, "end: option 1", {to.x, to.y}, false});
    drawing.notes.push_back("seen along the plane, its front is up");
    const auto& [relation, t, point] = truth.option_2;
    if (!t || !point) return;
    const Point2d hit{from.x + *t * (to.x - from.x), *t == 0 ? from.y : 0};
    drawing.figures.push_back({Figure::Kind::point, "option 2", {hit.x, hit.y}, true});
    drawing.figures.push_back({Figure::Kind::segment, "", {hit.x, hit.y, to.x, to.y}, false});
    const Vector3d apart = end - *point;
    drawing.notes.push_back("the options are " + decimal(std::hypot(apart.x, apart.y, apart.z)) + " apart, " +
                            decimal(1 - *t) + " of the step");
  }

  /// A step from one unit in front of x + y + z = 3 to its point (1, 1, 1): moves x and y of the end.
  static Question map_centre() { return {{{1, 1, 1}, -3}, {2, 1, 1}, {1, 1, 1}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {7, 8}; }

  static Hooks<point_plane_toi> hooks() {
    return {.scale = scale, .map_centre = map_centre, .map_axes = map_axes, .draw = draw};
  }

 private:
  /// A step on the lattice from one height over a plane through lattice points to another, in units of N . N.
  static Question step(DrawStream& c, double from, double to) {
    const Vector3d n = lattice_normal(c, 10);
    const Point3d foot = lattice_point_in_space(c), start = foot + lattice_across(c, n) + from * n;
    return {{n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}, start, foot + lattice_across(c, n) + to * n};
  }
};

}  // namespace touchstone::catalogue::rows
