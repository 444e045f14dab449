// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_plane_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/ray_plane.h"
#include "oracle/mixed/ray_plane.h"
#include "reference/mixed/ray_plane.h"
#include "robust/mixed/ray_plane.h"

namespace touchstone::catalogue::rows {

struct ray_plane : signatures::ray_plane {
  TOUCHSTONE_STAGED_MODULES(ray_plane)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 22",
                                     .question = "What do the ray in space and the plane N . p + d = 0 have in common?",
                                     .kind = Kind::set,
                                     .fields = {"ray", "plane"},
                                     .ulps = 14,
                                     .margin_degree = 2};

  struct decision {
    static LinePlaneRelation robust(const Question& q) {
      return ::touchstone::robust::ray_plane_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static constexpr bool ends = false;
  static bool has_length(const Question&) { return true; }
  static Question of(const Plane3d& plane, const Point3d& from, const Point3d& to) {
    return {{from, to - from}, plane};
  }

  static void hard_cases(HardCases<Question>& add) { line_plane_cases<ray_plane>(add); }

  /// From one unit in front of x + y + z = 3 along it: moves x and y of the direction.
  static Question map_centre() { return {{{2, 1, 1}, {1, -1, 0}}, {{1, 1, 1}, -3}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<ray_plane> hooks() {
    return {.as_open_sets = without_ends<ray_plane>,
            .scale = scale_line_and_plane<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
