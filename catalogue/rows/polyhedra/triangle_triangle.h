// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/triangle_orbits.h"
#include "catalogue/families/reported_triangles.h"
#include "catalogue/families/triangles/triangle_pairs.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/triangle_triangle.h"
#include "oracle/polyhedra/triangle_triangle.h"
#include "reference/polyhedra/triangle_triangle.h"
#include "robust/batch/triangle_triangle.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::catalogue::rows {

struct triangle_triangle : signatures::triangle_triangle {
  TOUCHSTONE_STAGED_MODULES(triangle_triangle)
  TOUCHSTONE_ARRAYS(triangle_triangle)

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "54",
      .question = "Is what two closed triangles in space have in common a point, a segment, an area?",
      .kind = Kind::decision,
      .fields = {"a", "b"},
      .answer = "relation",
      .margin_degree = 2,
      .cost = 17};

  static void hard_cases(HardCases<Question>& add) {
    add("crossing", crossing_triangles);
    add("small_lattice", [](DrawStream& c) -> Question {
      return {triangle_of(c, small_lattice_point), triangle_of(c, small_lattice_point)};
    });
    add("coplanar", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      return {plane.triangle(c), plane.triangle(c)};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Triangle3d t = plane.triangle(c);
      const Vector3d off = lattice_normal(c);
      return {t, {plane.point(c) + off, plane.point(c) + off, plane.point(c) + off}};
    });
    add("common_corner", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c);
      return {{p, lattice_point_in_space(c), lattice_point_in_space(c)},
              {lattice_point_in_space(c), lattice_point_in_space(c), p}};
    });
    add("common_edge", edges_on_a_line);
    add("corner_on", corner_on_triangle);
    add("edge_on_edge", edge_on_edge);
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      return {plane.triangle_without_area(c), plane.triangle(c)};
    });
    add("needles", crossing_needles);
    add("corner_rounded_onto", corner_rounded_onto);
    add("long_coplanar", long_coplanar);
    add("stretched", [](DrawStream& c) -> Question {
      Question question = crossing_triangles(c);
      auto& [a, b] = question;
      Stretch{c}(a, b);
      return question;
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {triangle_of(c, huge_or_small_point), triangle_of(c, huge_or_small_point)};
    });
    add("reported", [](DrawStream& c) -> Question { return reported_triangles(c); });
    add("coplanar_at_edge", coplanar_triangles<&CoplanarDraws::triangle_at_edge>);
    add("coplanar_within", coplanar_triangles<&CoplanarDraws::triangle_within>);
    add("coplanar_in_any_order", coplanar_triangles<&CoplanarDraws::other_triangle>);
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
};

}  // namespace touchstone::catalogue::rows
