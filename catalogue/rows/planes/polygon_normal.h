// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/draw/side_view.h"
#include "catalogue/families/rings.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/polygon_normal.h"
#include "oracle/planes/polygon_normal.h"
#include "reference/planes/polygon_normal.h"
#include "robust/planes/polygon_normal.h"

namespace touchstone::catalogue::rows {

struct polygon_normal : signatures::polygon_normal {
  TOUCHSTONE_STAGED_MODULES(polygon_normal)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "planes",
      .pages = "21",
      .question = "Which way does the polygon face: its normal by Newell's sum, and that of length 1?",
      .kind = Kind::measure,
      .fields = {"polygon"},
      .ulps = 22,
      .margin_degree = 2,
      .cost = 2,
      .time = grows(Growth::linear),
      .list_length = 4,
      .formula_answers_less = true,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add("triangle", [](DrawStream& c) -> Question {
      return {{{lattice_point_in_space(c), lattice_point_in_space(c), lattice_point_in_space(c)}}};
    });
    add("within_its_enclosure", [](DrawStream& c) -> Question {
      const NearTie z = near_tie(c);
      return {{{{0, 0, 0}, {z.t, -z.rest, 0}, {1, z.v, 0}}}};
    });
    add("parallelogram", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {{{p, p + a, p + a + b, p + b}}};
    });
    add("planar_ring", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {lifted(turned(simple_ring(c), c), p, a, b)};
    });
    add("rational_unit", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c);
      return {lifted(turned(convex_ring(c), c), p, {2, -1, 0}, {2, 0, -1})};  // (1, 2, 2) / 3
    });
    add("flat_first_corner", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {{{p, p + a, p + (2 + up_to(c, 3)) * a, p + b}}};
    });
    add("repeated_vertex", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      const std::uint64_t which = c.below(3);
      return {{{p, which == 0 ? p : p + a, which == 1 ? p + a : p + a + b, p + b, which == 2 ? p : p + b}}};
    });
    add("reflex_first_corner", [](DrawStream& c) -> Question {
      // A dart: p + a + b is beyond or on the line of its neighbours.
      const auto [p, a, b] = frame(c);
      const double far = 2 + up_to(c, 7);
      return {{{p + far * a, p + a + b, p + far * b, p}}};
    });
    add("figure_of_eight", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {{{p, p + a + b, p + a, p + b}}};  // its two halves cancel
    });
    add("collinear", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c);
      const Vector3d v = lattice_normal(c);
      return {{{p, p + small_integer(c) * v, p + small_integer(c) * v, p + small_integer(c) * v}}};
    });
    add("coincident", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{std::vector<Point3d>(3 + c.below(3), p)}};
    });
    add("beside_collinear", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c);
      const Vector3d v = lattice_normal(c);
      const double s = small_integer(c), t = small_integer(c);
      const Point3d q = p + s * v;
      return {{{p, {q.x + small_integer(c, 1), q.y, q.z}, p + t * v}}};
    });
    add("not_planar", [](DrawStream& c) -> Question {
      Polygon3d ring;
      for (std::uint64_t n = 4 + c.below(5); n > 0; --n) ring.vertices.push_back(lattice_point_in_space(c));
      return {ring};
    });
    add("far_from_origin", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      const auto moved = [](const Point3d& q) { return Point3d{q.x + 1000000.1, q.y + 0.3, q.z - 99.99}; };
      return {{{moved(p), moved(p + a), moved(p + a + b), moved(p + b)}}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      // An area halfway between two doubles but for a bit far below.
      const double bit = std::ldexp(1, -38 - integer_in(c, 0, 13)), far = c.coin() ? 0x1p-333 : 0;
      return {{{{0, 0, 0}, {1 + 0x1p-26, 0, 0}, {0, 1 + 0x1p-27 + bit, far}}}};
    });
    add("beyond_range", [](DrawStream& c) -> Question {
      const int up = integer_in(c, 400, 959), down = integer_in(c, 400, 999);
      const double n = one_to(c, 8), m = small_integer(c);
      return {{{{0, 0, 0}, {std::ldexp(n, up), 0, 0}, {0, std::ldexp(n, up), std::ldexp(m, -down)}}}};
    });
    add("closed_ring", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {lifted(closed(turned(simple_ring(c), c), c), p, a, b)};
    });
    add.unscaled("many_vertices", [](DrawStream& c) -> Question {
      const auto [p, a, b] = frame(c);
      return {lifted(turned(long_convex_ring(c), c), p, a, b)};
    });
  }

  /// Along the axis to which the normal is nearest; and the two edges of the slide.
  static void draw(Drawing& drawing, const Question& question, const PolygonNormal<double>&) {
    const Polygon3d& polygon = std::get<0>(question);
    const int axis = facing(question);
    const auto projected = [axis](const Point3d& p) {
      return axis == 0 ? Point2d{p.y, p.z} : axis == 1 ? Point2d{p.z, p.x} : Point2d{p.x, p.y};
    };
    Polygon2d flat;
    for (const Point3d& p : polygon.vertices) flat.vertices.push_back(projected(p));
    catalogue::draw(drawing, "polygon", flat, false);
    for (const int i : {0, 1}) {
      const Point2d a = flat[static_cast<std::size_t>(i)], b = flat[static_cast<std::size_t>(i) + 1];
      drawing.figures.push_back({Figure::Kind::arrow, i == 0 ? "v0" : "v1", {a.x, a.y, b.x, b.y}, false});
    }
    drawing.notes.push_back(std::string("seen along ") + "xyz"[axis] + " (" + "yzx"[axis] + " across, " + "zxy"[axis] +
                            " up); the arrows are the slide's two edges");
  }

  /// Three points of a line: moves x and y of the one in the middle.
  static Question map_centre() { return {{{{0, 0, 0}, {12, 12, 0}, {24, 24, 0}}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {4, 5}; }

  static Hooks<polygon_normal> hooks() { return {.map_centre = map_centre, .map_axes = map_axes, .draw = draw}; }

 private:
  struct Frame {
    Point3d origin;
    Vector3d a, b;
  };
  /// Small enough for rings of 2^40 to be lifted exactly.
  static Frame frame(DrawStream& c) {
    const Point3d p = lattice_point_in_space(c);
    const Vector3d a = lattice_normal(c, 3), b{small_integer(c), small_integer(c), small_integer(c)};
    return {p, a, b.x == 0 && b.y == 0 && b.z == 0 ? Vector3d{1, 0, 0} : b};
  }
  static Polygon3d lifted(const Polygon2d& ring, const Point3d& origin, const Vector3d& a, const Vector3d& b) {
    Polygon3d polygon;
    for (const Point2d& p : ring.vertices) polygon.vertices.push_back(origin + p.x * a + p.y * b);
    return polygon;
  }
  static int facing(const Question& question) {
    try {
      const auto unit = ask_robust<polygon_normal>(question).unit;
      if (!unit) return 2;
      const double size = largest(*unit);
      return std::fabs(unit->z) == size ? 2 : std::fabs(unit->y) == size ? 1 : 0;
    } catch (const InvalidInput&) {
      return 2;
    }
  }
};

}  // namespace touchstone::catalogue::rows
