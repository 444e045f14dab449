// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_plane_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/segment_plane.h"
#include "oracle/mixed/segment_plane.h"
#include "reference/mixed/segment_plane.h"
#include "robust/mixed/segment_plane.h"

namespace touchstone::catalogue::rows {

struct segment_plane : signatures::segment_plane {
  TOUCHSTONE_STAGED_MODULES(segment_plane)

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "22-23",
      .question = "What do the closed segment in space and the plane N . p + d = 0 have in common?",
      .kind = Kind::set,
      .fields = {"segment", "plane"},
      .ulps = 17,
      .margin_degree = 2};

  struct decision {
    static LinePlaneRelation robust(const Question& q) {
      return ::touchstone::robust::segment_plane_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static constexpr bool ends = true;
  static bool has_length(const Question& q) { return !(std::get<0>(q).a == std::get<0>(q).b); }
  static Question of(const Plane3d& plane, const Point3d& from, const Point3d& to) { return {{from, to}, plane}; }

  static void hard_cases(HardCases<Question>& add) { line_plane_cases<segment_plane>(add); }

  /// From one unit in front of x + y + z = 3 to its point (1, 1, 1): moves x and y of the end.
  static Question map_centre() { return {{{2, 1, 1}, {1, 1, 1}}, {{1, 1, 1}, -3}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<segment_plane> hooks() {
    return {.as_open_sets = without_ends<segment_plane>,
            .scale = scale_line_and_plane<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
