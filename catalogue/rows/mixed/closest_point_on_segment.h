// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/operation/stages_either.h"
#include "catalogue/signatures/mixed/closest_point_on_segment.h"
#include "oracle/mixed/closest_point_on_segment.h"
#include "reference/mixed/closest_point_on_segment.h"
#include "reference/standard/point_and_segment.h"
#include "robust/mixed/closest_point_on_segment.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_segment : signatures::closest_point_on_segment {
  TOUCHSTONE_MODULES_EITHER(closest_point_on_segment)
  using stages = StagesEither<::touchstone::robust::stages::closest_point_on_segment, Answers<double>>;
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 48-50",
                                     .question = "Which point of a segment is nearest to the point, and how far is it?",
                                     .kind = Kind::measure,
                                     .fields = {"point", "segment"},
                                     .ulps = 32,
                                     .margin_degree = 0,
                                     .cost = 4,
                                     .longest_vector = 2300};

  static void standard(const auto& add) {
    add("Ericson, closest point of a segment", [](const auto&... q) {
      return either<Answers>(::touchstone::reference::standard::closest_point_on_segment(q...));
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("foot_within_or_beyond", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double i = small_integer(c), j = small_integer(c);
      return seen(line.at(small_integer(c)) + line.across, line.between(i, j), line.in_plane);
    });
    add("foot_at_end", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double j = small_integer(c), off = small_integer(c, 1) * 0x1p-20;
      return seen(line.at(off) + line.across, line.between(0, j), line.in_plane);
    });
    add("on_segment_or_line", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double i = small_integer(c, 3), j = small_integer(c, 3);
      return seen(line.at(small_integer(c, 3)), line.between(i, j), line.in_plane);
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double i = small_integer(c, 1);
      return seen(line.origin, line.between(i, i), line.in_plane);
    });
    add("whole_distance", [](DrawStream& c) -> Question {
      // From the end, which is the nearest, or beyond it.
      const Step step = integer_step(c);
      const Point3d end = lattice_point_in_space(c, 20);
      return seen(end + step.displacement, {along(end, -up_to(c, 2), step.displacement), end}, false);
    });
    add("needle", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double length = scaled_up(c, 8, 30), i = small_integer(c);
      return seen(line.at(i) + line.across, line.between(-length, length), line.in_plane);
    });
    add("rounded_onto_segment", [](DrawStream& c) -> Question {
      const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c);
      const bool in_plane = c.coin();
      return seen(along(a, ordinary(c), b - a), {a, b}, in_plane);
    });
    add("full_mantissa", [](DrawStream& c) -> Question {
      const LongPlane plane = LongPlane::of(c);
      const Point3d p = plane.point(c), a = plane.point(c);
      const bool in_plane = c.coin();
      return seen(p, {a, plane.point(c)}, in_plane);
    });
    add("rounding", rounding);
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      const double turn = either_sign(c);
      const bool in_plane = c.coin();
      return seen({step.x, step.y, hair(c)}, {{-1, 0, 0}, {0, 0, turn}}, in_plane);
    });
    add("rounding_of_square", [](DrawStream& c) -> Question {
      // (2^27 + 2 k + 1)^2 + 1, whose last digit but one is the last that a double has.
      const double x = 0x1p27 + 1 + 2 * static_cast<double>(c.below(1 << 20)), y = either_sign(c);
      const bool in_plane = c.coin();
      return seen({x, y, hair(c)}, {{-x, 0, 0}, {0, 0, 0}}, in_plane);
    });
    add("stretched", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double i = small_integer(c), j = small_integer(c);
      Point3d p = line.at(small_integer(c)) + line.across;
      Segment3d s = line.between(i, j);
      Stretch{c}(p, s);
      return seen(p, s, line.in_plane);
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const Point3d p = typed_point(c), a = typed_point(c);
      const bool in_plane = c.coin();
      return seen(p, {a, typed_point(c)}, in_plane);
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d p = subnormal_point(c), a = subnormal_point(c);
      const bool in_plane = c.coin();
      return seen(p, {a, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}, in_plane);
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c), a = point_of_full_range(c);
      const bool in_plane = c.coin();
      return seen(p, {a, point_of_full_range(c)}, in_plane);
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c);
      const bool in_plane = c.coin();
      return seen(p, {a, c.coin() ? b : Point3d{1, b.y, b.z}}, in_plane);
    });
  }

  /// Moves the point at the end (12, 12).
  static Question map_centre() { return InPlane{{12, 12}, {{0.5, 0.5}, {12, 12}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<closest_point_on_segment> hooks() {
    return {.map_centre = map_centre, .map_axes = map_axes, .laws = {.maps = Laws::Maps::axes}};
  }

 private:
  /// Along a diagonal: the foot of an odd step is half a step from two of its points, and x halfway between doubles.
  static Question rounding(DrawStream& c) {
    const double x = halfway_number(c), odd = 1 + 2 * up_to(c, 7), length = 64, far = either_sign(c);
    const Point3d start{x, 0, 0}, end{x + length, far * length, 0};
    const double z = c.coin() ? 1 : 0;
    const bool in_plane = c.coin();
    return seen({x + odd, 0, hair(c)}, {start, {end.x, end.y, z}}, in_plane);
  }

  static Question seen(const Point3d& p, const Segment3d& s, bool in_plane) {
    if (!in_plane) return InSpace{p, s};
    return InPlane{without_z(p), without_z(s)};
  }
};

}  // namespace touchstone::catalogue::rows
