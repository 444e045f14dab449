// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/coplanar_draws.h"
#include "catalogue/families/meshes/triangle_orbits.h"
#include "catalogue/families/reported_triangles.h"
#include "catalogue/families/triangle_draws.h"
#include "catalogue/operation/row.h"
#include "oracle/polyhedra/triangle_triangle.h"
#include "reference/polyhedra/triangle_triangle.h"
#include "robust/batch/triangle_triangle.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::catalogue::rows {

struct triangle_triangle {
  TOUCHSTONE_MODULES(triangle_triangle)
  TOUCHSTONE_ARRAYS(triangle_triangle)
  using stages = ::touchstone::robust::stages::triangle_triangle;
  using Question = std::tuple<Triangle3d, Triangle3d>;

  static const Metadata& metadata() {
    static const Metadata metadata{
        .name = "triangle_triangle",
        .chapter = "polyhedra",
        .pages = "54",
        .question = "Is what two closed triangles in space have in common a point, a segment, an area?",
        .kind = Kind::decision,
        .fields = {"a", "b"},
        .answer = "relation",
        .margin_degree = 2,
        .cost = 17};
    return metadata;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"crossing", crossing},
        {"small_lattice",
         [](DrawStream& c) -> Question {
           const Triangle3d t = of(c, small_lattice_point);
           return {t, of(c, small_lattice_point)};
         }},
        {"coplanar",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Triangle3d t = plane.triangle(c);
           return {t, plane.triangle(c)};
         }},
        {"parallel",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Triangle3d t = plane.triangle(c);
           const Vector3d off = lattice_normal(c);
           const Triangle3d other = plane.triangle(c);
           return {t, {other.a + off, other.b + off, other.c + off}};
         }},
        {"common_corner",
         [](DrawStream& c) -> Question {
           const Point3d p = lattice_point_in_space(c), b = lattice_point_in_space(c), d = lattice_point_in_space(c),
                         e = lattice_point_in_space(c);
           return {{p, b, d}, {e, lattice_point_in_space(c), p}};
         }},
        {"common_edge",
         [](DrawStream& c) -> Question {
           // Along one line; the edges may share all of it, a part, an end or nothing.
           const LatticePlane edge = LatticePlane::of(c);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           const double l = small_integer(c, 3);
           const Point3d p = lattice_point_in_space(c);
           return {{edge.at(i, 0), edge.at(j, 0), p}, {edge.at(k, 0), lattice_point_in_space(c), edge.at(l, 0)}};
         }},
        {"corner_on",
         [](DrawStream& c) -> Question {
           // On a face, an edge or a corner, or near them in their plane.
           const LatticePlane plane = LatticePlane::of(c);
           const Triangle3d t = plane.triangle(c);
           const Point3d p = plane.point(c), q = lattice_point_in_space(c);
           return {t, {q, p, lattice_point_in_space(c)}};
         }},
        {"edge_on_edge",
         [](DrawStream& c) -> Question {
           const LatticePlane cross = LatticePlane::of(c);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           const double l = small_integer(c, 3);
           const Point3d p = lattice_point_in_space(c);
           return {{cross.at(i, 0), cross.at(j, 0), p}, {cross.at(0, k), cross.at(0, l), lattice_point_in_space(c)}};
         }},
        {"no_area",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           const Triangle3d t{plane.at(i, 0), plane.at(j, 0), plane.at(k, 0)};
           return {t, plane.triangle(c)};
         }},
        {"needles",
         [](DrawStream& c) -> Question {
           // Thousands of millions long, a few units wide, across each other.
           const double length = std::ldexp(1, 30 + static_cast<int>(c.below(12)));
           const auto unit = [&c] { return small_integer(c, 3); };
           const double ay = unit(), az = unit(), by = unit(), bz = unit(), cx = unit(), cz = unit();
           const Triangle3d t{{-length, ay, az}, {length, by, 0}, {length, 0, bz}};
           const double dx = unit(), dz = unit();
           return {t, {{cx, -length, cz}, {dx, length, 0}, {0, length, dz}}};
         }},
        {"corner_rounded_onto",
         [](DrawStream& c) -> Question {
           const Triangle3d t = of(c, ordinary_point_in_space);
           const double i = ordinary(c), j = ordinary(c);
           const Point3d p = t.a + (i * (t.b - t.a) + j * (t.c - t.a)), q = ordinary_point_in_space(c);
           return {t, {p, q, ordinary_point_in_space(c)}};
         }},
        {"long_coplanar",
         [](DrawStream& c) -> Question {
           const LongPlane plane = LongPlane::of(c);
           const auto point = [&plane](DrawStream& draws) { return plane.point(draws); };
           const Triangle3d t = of(c, point);
           return {t, of(c, point)};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           Question question = crossing(c);
           auto& [a, b] = question;
           stretch(c, a.a, a.b, a.c, b.a, b.b, b.c);
           return question;
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           // Differences overflow, and products of what does not.
           const auto point = [](DrawStream& draws) {
             const auto number = [&draws] {
               const double n = small_integer(draws, 1);
               return std::ldexp(n, draws.below(2) == 1 ? 1023 : 0);
             };
             const double x = number(), y = number();
             return Point3d{x, y, number()};
           };
           const Triangle3d t = of(c, point);
           return {t, of(c, point)};
         }},
        {"reported",
         [](DrawStream& c) -> Question {
           const auto [a, b] = reported_triangles(c);
           return {a, b};
         }},
        {"coplanar_at_edge",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Triangle3d t = coplanar.triangle();
           return either_first(c, t, coplanar.triangle_at_edge());
         }},
        {"coplanar_within",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Triangle3d t = coplanar.triangle();
           return either_first(c, t, coplanar.triangle_within());
         }},
        {"coplanar_in_any_order",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Triangle3d t = coplanar.triangle();
           return either_first(c, t, coplanar.other_triangle());
         }},
    };
  }

  /// Without edges they have nothing in common where a plane has one on either side and not both within itself: then
  /// the certificate begins with such a plane.
  static std::optional<TriangleTriangleRelation> as_open_sets(const TriangleTriangleRelation& truth,
                                                              const Question& question) {
    if (truth == TriangleTriangleRelation::none) return std::nullopt;
    const auto certificate = ask_oracle<triangle_triangle>(question).certificate();
    if (certificate.facts.front().second.empty()) return std::nullopt;
    return TriangleTriangleRelation::none;
  }

  /// Two triangles whose edges cross in (24, 24, 24); moves a corner of the first.
  static Question map_centre() {
    return {{{0.5, 0.5, 0.5}, {48, 48, 48}, {0, 48, 0}}, {{24, 24, 3}, {24, 24, 45}, {60, 0, 24}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  struct decision {
    static TriangleTriangleRelation robust(const Question& q) {
      return ::touchstone::robust::triangle_triangle(std::get<0>(q), std::get<1>(q));
    }
    static TriangleTriangleRelation oracle(const auto& q) {
      return ::touchstone::oracle::triangle_triangle_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static std::uint64_t domain_count(int size) { return TriangleOrbits::of(size).count(); }
  static Question domain_at(int size, std::uint64_t index) { return TriangleOrbits::of(size).at(index); }
  static std::uint64_t domain_weight(int size, std::uint64_t index) { return TriangleOrbits::of(size).weight(index); }

  static Hooks<triangle_triangle> hooks() {
    return {.as_open_sets = as_open_sets,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .domain_weight = domain_weight,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  template <class Draw>
  static Triangle3d of(DrawStream& c, const Draw& point) {
    const Point3d a = point(c), b = point(c);
    return {a, b, point(c)};
  }

  static Question either_first(DrawStream& c, const Triangle3d& t, const Triangle3d& other) {
    return c.below(2) == 1 ? Question{other, t} : Question{t, other};
  }

  /// Triangles around one point, or near it, in two planes.
  static Question crossing(DrawStream& c) {
    const LatticePlane plane = LatticePlane::of(c), other = LatticePlane::of(c);
    const Triangle3d t = plane.triangle(c);
    return {t, LatticePlane{plane.origin, other.u, other.v}.triangle(c)};
  }
};

}  // namespace touchstone::catalogue::rows
