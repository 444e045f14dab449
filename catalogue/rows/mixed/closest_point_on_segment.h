// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/operation/stages_either.h"
#include "oracle/mixed/closest_point_on_segment.h"
#include "reference/mixed/closest_point_on_segment.h"
#include "reference/standard/point_and_segment.h"
#include "robust/mixed/closest_point_on_segment.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_segment {
  template <class Real>
  using Answers = std::variant<ClosestPoint2<Real>, ClosestPoint3<Real>>;
  TOUCHSTONE_MODULES_EITHER(closest_point_on_segment)
  using stages = StagesEither<::touchstone::robust::stages::closest_point_on_segment, Answers<double>>;
  using InPlane = std::tuple<Point2d, Segment2d>;
  using InSpace = std::tuple<Point3d, Segment3d>;
  using Question = std::variant<InPlane, InSpace>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = "closest_point_on_segment",
                                   .chapter = "mixed",
                                   .pages = "9, 48-50",
                                   .question = "Which point of a segment is nearest to the point, and how far is it?",
                                   .kind = Kind::measure,
                                   .fields = {"point", "segment"},
                                   .ulps = 32,
                                   .margin_degree = 0,
                                   .cost = 4,
                                   .longest_vector = 2300};
    return metadata;
  }

  static void standard(const auto& add) {
    add("Ericson, closest point of a segment", [](const auto&... q) {
      return either<Answers>(::touchstone::reference::standard::closest_point_on_segment(q...));
    });
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"foot_within_or_beyond",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double i = small_integer(c), j = small_integer(c);
           return seen(line.at(small_integer(c)) + line.across, line.between(i, j), line.in_plane);
         }},
        {"foot_at_end",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double j = small_integer(c), off = small_integer(c, 1) * 0x1p-20;
           return seen(line.at(off) + line.across, line.between(0, j), line.in_plane);
         }},
        {"on_segment_or_line",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double i = small_integer(c, 3), j = small_integer(c, 3);
           return seen(line.at(small_integer(c, 3)), line.between(i, j), line.in_plane);
         }},
        {"zero_length",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double i = small_integer(c, 1);
           return seen(line.origin, line.between(i, i), line.in_plane);
         }},
        {"whole_distance",
         [](DrawStream& c) -> Question {
           // From the end, which is the nearest, or beyond it.
           const Step step = whole_step(c);
           const Point3d end = lattice_point_in_space(c, 20);
           const Point3d other = along(end, -static_cast<double>(c.below(3)), step.way);
           return seen(end + step.way, {other, end}, false);
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double length = scaled_up(c, 8, 30), i = small_integer(c);
           return seen(line.at(i) + line.across, line.between(-length, length), line.in_plane);
         }},
        {"rounded_onto_segment",
         [](DrawStream& c) -> Question {
           const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c);
           const bool in_plane = c.below(2) == 1;
           return seen(along(a, ordinary(c), b - a), {a, b}, in_plane);
         }},
        {"full_mantissa",
         [](DrawStream& c) -> Question {
           const LongPlane plane = LongPlane::of(c);
           const Point3d p = plane.point(c), a = plane.point(c);
           const bool in_plane = c.below(2) == 1;
           return seen(p, {a, plane.point(c)}, in_plane);
         }},
        {"rounding", rounding},
        {"rounding_of_distance",
         [](DrawStream& c) -> Question {
           const HalfwayStep step = halfway_step(c);
           const double turn = c.below(2) == 1 ? -1 : 1;
           const bool in_plane = c.below(2) == 1;
           return seen({step.x, step.y, hair(c)}, {{-1, 0, 0}, {0, 0, turn}}, in_plane);
         }},
        {"rounding_of_square",
         [](DrawStream& c) -> Question {
           // (2^27 + 2 k + 1)^2 + 1, whose last digit but one is the last that a double has.
           const double x = 0x1p27 + 1 + 2 * static_cast<double>(c.below(1 << 20)), y = c.below(2) == 1 ? -1 : 1;
           const bool in_plane = c.below(2) == 1;
           return seen({x, y, hair(c)}, {{-x, 0, 0}, {0, 0, 0}}, in_plane);
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           const LatticeLine line = LatticeLine::of(c);
           const double i = small_integer(c), j = small_integer(c);
           Point3d p = line.at(small_integer(c)) + line.across;
           Segment3d s = line.between(i, j);
           stretch(c, p, s.a, s.b);
           return seen(p, s, line.in_plane);
         }},
        {"typed",
         [](DrawStream& c) -> Question {
           const Point3d p = typed_point(c), a = typed_point(c);
           const bool in_plane = c.below(2) == 1;
           return seen(p, {a, typed_point(c)}, in_plane);
         }},
        {"subnormal",
         [](DrawStream& c) -> Question {
           const Point3d p = subnormal_point(c), a = subnormal_point(c);
           const bool in_plane = c.below(2) == 1;
           return seen(p, {a, c.below(2) == 1 ? lattice_point_in_space(c, 4) : subnormal_point(c)}, in_plane);
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           const Point3d p = point_of_whole_range(c), a = point_of_whole_range(c);
           const bool in_plane = c.below(2) == 1;
           return seen(p, {a, point_of_whole_range(c)}, in_plane);
         }},
        {"either_zero",
         [](DrawStream& c) -> Question {
           const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c);
           const bool in_plane = c.below(2) == 1;
           return seen(p, {a, c.below(2) == 1 ? b : Point3d{1, b.y, b.z}}, in_plane);
         }},
    };
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
    const HalfwayNumber x = halfway_number(c);
    const double odd = 1 + 2 * static_cast<double>(c.below(8)), length = 64, far = c.below(2) == 1 ? -1 : 1;
    const Point3d start{x.most, 0, 0}, end{x.most + length, far * length, 0};
    const double z = c.below(2) == 1 ? 1 : 0;
    const bool in_plane = c.below(2) == 1;
    return seen({x.most + odd, 0, hair(c)}, {start, {end.x, end.y, z}}, in_plane);
  }

  static Question seen(const Point3d& p, const Segment3d& s, bool in_plane) {
    if (!in_plane) return InSpace{p, s};
    return InPlane{without_z(p), without_z(s)};
  }
};

}  // namespace touchstone::catalogue::rows
