// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_box_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/segment_aabb.h"
#include "oracle/mixed/segment_aabb.h"
#include "reference/mixed/segment_aabb.h"
#include "reference/standard/slabs.h"
#include "robust/mixed/segment_aabb.h"

namespace touchstone::catalogue::rows {

struct segment_aabb : signatures::segment_aabb {
  TOUCHSTONE_STAGED_MODULES(segment_aabb)

  struct decision {
    static PassageRelation robust(const Question& question) {
      return applied([](const auto&... q) { return ::touchstone::robust::segment_aabb_relation(q...); }, question);
    }
  };

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "45-47",
                                     .question = "Where does the closed segment enter and leave the axis-aligned box?",
                                     .kind = Kind::measure,
                                     .fields = {"segment", "aabb"},
                                     .ulps = 3};

  static Question of(const Course& course, const Aabb3d& box, bool in_plane) {
    const auto& [p, v] = course;
    const Point3d q = p + v;
    if (in_plane) return InPlane{{{p.x, p.y}, {q.x, q.y}}, without_z(box)};
    return InSpace{{p, q}, box};
  }
  static bool has_interior(const Aabb2d& box) { return box.min.x < box.max.x && box.min.y < box.max.y; }
  static bool has_interior(const Aabb3d& box) { return has_interior(without_z(box)) && box.min.z < box.max.z; }

  static void standard(const auto& add) {
    add("slabs, times the reciprocal of the direction", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_aabb<::touchstone::reference::standard::ByReciprocalDirection>(
          q...);
    });
    add("slabs, from the box's center", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_aabb<::touchstone::reference::standard::ByHalfExtents>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) { line_box_cases<segment_aabb>(add); }

  static void repair(Question& question) {
    std::visit([](auto& q) { put_in_order(std::get<1>(q)); }, question);
  }

  /// Through the corner (24, 36) of a box; moves the end.
  static Question map_centre() { return InPlane{{{0, 24}, {40, 44}}, {{24, 0}, {48, 36}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {2, 3}; }

  static Hooks<segment_aabb> hooks() {
    return {.as_open_sets = none_if_grazing<segment_aabb>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
