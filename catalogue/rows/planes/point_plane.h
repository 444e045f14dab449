// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/draw/side_view.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/point_plane.h"
#include "oracle/planes/point_plane.h"
#include "reference/planes/point_plane.h"
#include "robust/batch/point_plane.h"
#include "robust/planes/point_plane.h"

namespace touchstone::catalogue::rows {

struct point_plane : signatures::point_plane {
  TOUCHSTONE_STAGED_MODULES(point_plane)
  TOUCHSTONE_ARRAYS(point_plane)

  struct decision {
    static PlaneSide robust(const Question& q) {
      return ::touchstone::robust::point_plane_side(std::get<0>(q), std::get<1>(q));
    }
  };

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "planes",
      .pages = "22",
      .question = "Is the point in front of, on or behind the plane N . p + d = 0, and how far from it?",
      .kind = Kind::measure,
      .fields = {"plane", "point"},
      .ulps = 13,
      .margin_degree = 2,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add("on_plane", [](DrawStream& c) -> Question { return over_plane(c, 0); });
    add("beside_plane", [](DrawStream& c) -> Question { return over_plane(c, small_integer(c, 1)); });
    add("rational_distance", [](DrawStream& c) -> Question {
      const Vector3d n = normal_of_integer_length(c);
      const Point3d p = lattice_point_in_space(c);
      return {{n, integer(c, 30)}, p};
    });
    add("axis_normal", [](DrawStream& c) -> Question {
      const double k = one_to(c, 1 << 20), y = integer(c, 26);
      const Point3d p = lattice_point_in_space(c, 53);
      return {{{0, either_sign(c) * k, 0}, c.coin() ? k * y : -k * y}, {p.x, y, p.z}};
    });
    add("normal_of_any_size", [](DrawStream& c) -> Question {
      const double height = small_integer(c, 1);
      const int k = integer_in(c, -1050, 949);
      const auto [plane, p] = over_plane(c, height);
      return {{scaled(plane.normal, k), std::ldexp(plane.offset, k)}, p};
    });
    add("uneven_normal", [](DrawStream& c) -> Question {
      const double small = scaled_down(c, 8, 300);
      const Point3d p = lattice_point_in_space(c);
      return {{{one_to(c, 8), small, 0}, small_integer(c)}, p};
    });
    add("halfway", [](DrawStream& c) -> Question {
      const double y = 0x1p52 + up_to(c, 15);
      return {{{0, power_of_two(c, 0, 3), 0}, 0.5 + small_integer(c)}, {integer(c, 3), y, 0}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      // The height is halfway between two doubles but for one bit, more than 64 digits below the first.
      return {{{0, 1, 0}, beside_half_an_ulp(c, -64, 16)}, {0, 1, 0}};
    });
    add("root_beside_a_tie", [](DrawStream& c) -> Question {
      // x over the root of 2, in binary 53 digits, a half, and twelve zeros; then digits that decide. Found by
      // trying all x.
      static constexpr int roots[]{2827, 17619, 28489, 60223, 73721, 87219, 97213, 103703};
      const double x = roots[c.below(8)];
      return {{{1, 1, 0}, 0}, {either_sign(c) * x, 0, integer(c, 20)}};
    });
    add("terms_below_least", terms_below_least);
    add("subnormal_times_huge", [](DrawStream& c) -> Question {
      const double huge = one_to(c, 8), small = one_to(c, 64), offset = std::ldexp(huge * small, -531);
      return {{{std::ldexp(huge, 500), 0, 0}, c.one_in(4) ? offset : -offset}, {std::ldexp(small, -1030), 0, 0}};
    });
    add("as_wide_as_a_lattice", [](DrawStream& c) -> Question {
      // The terms span about 124 binary digits, from where on their sum does not fit two words.
      const double size = 8 + up_to(c, 7);
      const double x = std::ldexp(size, integer_in(c, 57, 60)), y = c.one_in(4) ? -x : x;
      return {{{x, y, x}, 1}, {x, y, x}};
    });
    add("beyond_range", [](DrawStream& c) -> Question {
      const Vector3d n = lattice_normal(c, 3);
      const double x = std::ldexp(one_to(c, 8), 1020), y = either_sign(c) * x;
      return {{n, std::ldexp(small_integer(c), 1020)}, {x, y, x}};
    });
    add("rounded_on_plane", [](DrawStream& c) -> Question {
      const Vector3d n{ordinary(c), ordinary(c), ordinary(c)}, p{ordinary(c), ordinary(c), ordinary(c)};
      return valid({n, -dot(n, p)}, p);
    });
    add("typed_on_plane", [](DrawStream& c) -> Question {
      const Vector3d n{typed(c), typed(c), typed(c)}, p{typed(c), typed(c), typed(c)};
      return valid({n, -dot(n, p)}, p);
    });
    add("zero_normal", [](DrawStream& c) -> Question {
      return {{{0.0, zero(c), 0.0}, small_integer(c)}, lattice_point_in_space(c)};
    });
  }

  /// The normal has no unit: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [plane, p] = question;
    plane.offset = std::ldexp(plane.offset, k);
    lengthen(p, k);
  }

  /// From the side: the plane is a line, the point over it at its distance.
  static void draw(Drawing& drawing, const Question&, const PointPlane<double>& truth) {
    const double distance = truth.signed_distance;
    SideView::draw_plane(drawing, -std::fabs(distance), std::fabs(distance), distance);
    drawing.figures.push_back({Figure::Kind::point, "point", {0, distance}, false});
    drawing.notes.push_back("seen along the plane, its front is up");
  }

  /// The plane x + y + z = 3 and its point (1, 1, 1): moves x and y.
  static Question map_centre() { return {{{1, 1, 1}, -3}, {1, 1, 1}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {4, 5}; }

  static Hooks<point_plane> hooks() {
    return {.scale = scale, .map_centre = map_centre, .map_axes = map_axes, .draw = draw};
  }

 private:
  /// A lattice point that is `height` over a plane through lattice points, in units of the normal.
  static Question over_plane(DrawStream& c, double height) {
    const Vector3d n = lattice_normal(c);
    const Point3d foot = lattice_point_in_space(c), p = foot + lattice_across(c, n);
    return {{n, height - dot(n, Vector3d{foot.x, foot.y, foot.z})}, p};
  }

  /// Four squares make a normal whose length is their sum (Euler).
  static Vector3d normal_of_integer_length(DrawStream& c) {
    const double m = small_integer(c), n = small_integer(c), p = small_integer(c), q = small_integer(c);
    const Vector3d v{m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)};
    return largest(v) == 0 ? Vector3d{1, 2, 2} : v;
  }

  static Question valid(const Plane3d& plane, const Vector3d& p) {
    return {largest(plane.normal) == 0 ? Plane3d{{0, 1, 0}, plane.offset} : plane, {p.x, p.y, p.z}};
  }
};

}  // namespace touchstone::catalogue::rows
