// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/many_points.h"
#include "catalogue/families/meshes/cloud_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/convex_hull.h"
#include "oracle/volumes/convex_hull.h"
#include "reference/volumes/convex_hull.h"
#include "robust/volumes/convex_hull.h"

namespace touchstone::catalogue::rows {

struct convex_hull : signatures::convex_hull {
  TOUCHSTONE_STAGED_MODULES(convex_hull)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "35-42",
      .question = "Which triangles, corners at some of these points, bound their convex hull?",
      .kind = Kind::checked,
      .fields = {"points"},
      .margin_degree = 3,
      .cost = 19,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::quadratic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    cloud_cases(add);
    large_cloud_cases(add);
    add.unscaled("many_points", [](DrawStream& c) -> Question { return many_points_and_one_far(c); });
  }

  static std::string defect(const Question& question, const ConvexHull& hull) {
    return ::touchstone::oracle::convex_hull_defect(std::get<0>(question), hull);
  }
  static Excess excess(const Question& question, const ConvexHull& hull, const ConvexHull&) {
    return excess_of_hull(std::get<0>(question), hull);
  }

  /// The faces, or the points alone where they are in one plane.
  static void draw(Drawing& drawing, const Question& question, const ConvexHull& hull) {
    const Points& points = std::get<0>(question);
    catalogue::draw(drawing, "", points, false);
    if (hull.faces) catalogue::draw(drawing, "", Meshd{points, *hull.faces}, true);
    Polygon3d polygon;
    for (const Index i : hull.polygon.value_or(std::vector<Index>())) polygon.vertices.push_back(points[i]);
    if (hull.polygon) catalogue::draw(drawing, "", polygon, true);
  }

  /// Six points of the grid of size^3, in ascending order, equal ones among them: all, without regard to their order.
  static constexpr std::uint64_t chosen = 6;
  static std::uint64_t multisets(std::uint64_t of, std::uint64_t chosen) {
    std::uint64_t count = 1;
    for (std::uint64_t i = 1; i <= chosen; ++i) count = count * (of + i - 1) / i;
    return count;
  }
  static std::uint64_t domain_count(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return multisets(n * n * n, chosen);
  }
  static Question domain_at(int size, std::uint64_t index) {
    const auto n = static_cast<std::uint64_t>(size);
    Points points;
    std::uint64_t first = 0;  // the least place on the grid that the next one may have
    for (std::uint64_t left = chosen; left > 0; --left) {
      for (;; ++first) {
        const std::uint64_t with_first = multisets(n * n * n - first, left - 1);
        if (index < with_first) break;
        index -= with_first;
      }
      points.push_back(
          {static_cast<double>(first % n), static_cast<double>(first / n % n), static_cast<double>(first / n / n)});
    }
    return points;
  }

  /// A point inside a face.
  static Question map_centre() { return {{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}, {4, 4, 4}}}; }

  static Hooks<convex_hull> hooks() {
    return {.defect = defect,
            .excess = excess,
            .map_centre = map_centre,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at};
  }
};

}  // namespace touchstone::catalogue::rows
