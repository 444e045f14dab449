// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/box_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/reflect_wall.h"
#include "oracle/response/reflect_wall.h"
#include "reference/response/reflect_wall.h"
#include "robust/response/reflect_wall.h"

namespace touchstone::catalogue::rows {

struct reflect_wall : signatures::reflect_wall {
  TOUCHSTONE_MODULES(reflect_wall)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "67",
      .question = "Which velocity has a body after it has bounced off a wall across an axis?",
      .kind = Kind::measure,
      .fields = {"velocity", "axis"},
      .answer = "velocity",
      .margin_degree = 0};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", [](DrawStream& c) -> Question { return bounce(lattice_velocity(c), c); });
    add("along_the_wall", [](DrawStream& c) -> Question {
      const Vector3d v = lattice_velocity(c);
      const double none = zero(c);
      switch (c.below(3)) {
        case 0: return {{none, v.y, v.z}, Axis::x};
        case 1: return {{v.x, none, v.z}, Axis::y};
        default: return {{v.x, v.y, none}, Axis::z};
      }
    });
    add("straight", [](DrawStream& c) -> Question {
      const double speed = integer(c, 53);
      switch (c.below(3)) {
        case 0: return {{speed, 0, 0}, Axis::x};
        case 1: return {{0, speed, 0}, Axis::y};
        default: return {{0, 0, speed}, Axis::z};
      }
    });
    add("least_and_greatest", [](DrawStream& c) -> Question {
      const auto end = [&c] {
        const double size = c.coin() ? 0x1.fffffffffffffp+1023 : 0x1p-1074;
        return either_sign(c) * size;
      };
      return bounce({end(), end(), end()}, c);
    });
  }

  /// The kinetic energy gained, times 2 over the mass.
  static std::vector<mpq_class> residuals(const Question& question, const Vector3d& after) {
    const auto square = [](const Vector3d& v) {
      const mpq_class x = exact_value(v.x), y = exact_value(v.y), z = exact_value(v.z);
      return mpq_class(x * x + y * y + z * z);
    };
    return {mpq_class(square(after) - square(std::get<0>(question)))};
  }

  static Question map_centre() { return {{12, -5, 3}, Axis::x}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    const auto& [velocity, axis] = question;
    const Vector3d normal{axis == Axis::x ? 1.0 : 0.0, axis == Axis::y ? 1.0 : 0.0, axis == Axis::z ? 1.0 : 0.0};
    draw_bounce(drawing, velocity, normal, truth);
  }

  static Hooks<reflect_wall> hooks() {
    return {
        .residuals = residuals, .map_centre = map_centre, .map_axes = map_axes, .draw = draw, .laws = {.scales = true}};
  }

 private:
  static Vector3d lattice_velocity(DrawStream& c) {
    const Point3d p = lattice_point_of_box(c, 40);
    return {p.x, p.y, p.z};
  }
  static Question bounce(const Vector3d& velocity, DrawStream& c) { return {velocity, static_cast<Axis>(c.below(3))}; }
};

}  // namespace touchstone::catalogue::rows
