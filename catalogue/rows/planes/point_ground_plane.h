// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/point_ground_plane.h"
#include "oracle/planes/point_ground_plane.h"
#include "reference/planes/point_ground_plane.h"
#include "robust/planes/point_ground_plane.h"

namespace touchstone::catalogue::rows {

struct point_ground_plane : signatures::point_ground_plane {
  TOUCHSTONE_MODULES(point_ground_plane)

  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "planes",
                                     .pages = "20",
                                     .question = "Is the point above, on or below the ground plane y = 0 (y is up)?",
                                     .kind = Kind::decision,
                                     .fields = {"point"},
                                     .answer = "side"};

  static void hard_cases(HardCases<Question>& add) {
    add("on_ground", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{p.x, zero(c), p.z}};
    });
    add("beside_ground", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{p.x, small_integer(c, 1), p.z}};
    });
    add("subnormal_height", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{p.x, subnormal(c), p.z}};
    });
    add("far_out", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{std::ldexp(p.x, 970), p.y, std::ldexp(p.z, 970)}};
    });
    add("huge_height", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 53);
      return {{p.x, std::ldexp(p.y, 970), p.z}};
    });
    add("difference_of_typed", [](DrawStream& c) -> Question {
      const double a = typed(c), b = typed(c), sum = a + b;  // 0.1 + 0.2 - 0.3
      return {{a, sum - typed(c), b}};
    });
  }

  /// From the front: x across, y up.
  static void draw(Drawing& drawing, const Question& question, const Height&) {
    const Point3d& p = std::get<0>(question);
    drawing.figures.push_back({Figure::Kind::line, "ground", {p.x - 1, 0, p.x + 1, 0}, false});
    drawing.figures.push_back({Figure::Kind::point, "point", {p.x, p.y}, false});
    drawing.notes.push_back("seen along z: x across, y up");
  }

  /// Moves x and y: the formula is right everywhere.
  static Question map_centre() { return {{0.5, 0, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<point_ground_plane> hooks() {
    return {.map_centre = map_centre, .map_axes = map_axes, .draw = draw, .laws = {.scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
