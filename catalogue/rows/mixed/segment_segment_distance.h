// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/operation/stages_either.h"
#include "catalogue/signatures/mixed/segment_segment_distance.h"
#include "oracle/mixed/segment_segment_distance.h"
#include "reference/mixed/segment_segment_distance.h"
#include "reference/standard/pair_of_segments.h"
#include "robust/mixed/segment_segment_distance.h"

namespace touchstone::catalogue::rows {

struct segment_segment_distance : signatures::segment_segment_distance {
  TOUCHSTONE_MODULES_EITHER(segment_segment_distance)
  using stages = StagesEither<::touchstone::robust::stages::segment_segment_distance, Answers<double>>;
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "9, 12-13, 48-50",
      .question = "Which points of two segments are nearest to each other, and how far is it?",
      .kind = Kind::measure,
      .fields = {"a", "b"},
      .ulps = 51,
      .margin_degree = 0,
      .cost = 20,
      .longest_vector = 2300};

  static void standard(const auto& add) {
    add("Ericson, closest points of segments", [](const auto&... q) {
      return either<Answers>(
          ::touchstone::reference::standard::segment_segment_distance<::touchstone::reference::standard::ByClamping>(
              q...));
    });
    add("Eberly, robust closest points of segments", [](const auto&... q) {
      return either<Answers>(
          ::touchstone::reference::standard::segment_segment_distance<::touchstone::reference::standard::OnSquare>(
              q...));
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("crossing_or_skew", crossing_or_skew);
    add("parallel", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      return side_by_side(c, line, line.across);
    });
    add("collinear", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      return side_by_side(c, line, {0, 0, 0});
    });
    add("nearly_parallel", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      auto [a, b] = in_space(c, line, line.across);
      b.b.x += small_integer(c, 1) * 0x1p-20;
      return seen(a, b, line.in_plane);
    });
    add("common_end", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c), other = LatticeLine::of(c);
      const bool in_plane = line.in_plane || other.in_plane;
      const Point3d end = along(line.origin, small_integer(c), other.displacement);
      return seen({line.origin, end}, {end, along(end, small_integer(c), line.displacement)}, in_plane);
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double i = small_integer(c, 3), j = c.coin() ? i : small_integer(c, 3);
      const Point3d p = line.at(small_integer(c, 3)) + line.across;
      const bool first = c.coin();
      return first ? seen({p, p}, line.between(i, j), line.in_plane) : seen(line.between(i, j), {p, p}, line.in_plane);
    });
    add("whole_distance", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const Point3d p = lattice_point_in_space(c, 20), q = p + step.displacement;
      const double back = -up_to(c, 2), on = up_to(c, 2);
      return seen({along(p, back, step.displacement), p}, {q, along(q, on, step.displacement)}, false);
    });
    add("needles", [](DrawStream& c) -> Question {
      const LatticeLine line = LatticeLine::of(c);
      const double length = scaled_up(c, 8, 30), shorter = scaled_up(c, 8, 30);
      const Point3d p = line.at(small_integer(c)) + line.across;
      return seen(line.between(-length, length), {p, along(p, shorter, lattice_normal(c, 3))}, line.in_plane);
    });
    add("rounded_crossing", [](DrawStream& c) -> Question {
      const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c), d = ordinary_point_in_space(c);
      const Point3d on_a = along(a, ordinary(c), b - a);
      const bool in_plane = c.coin();
      return seen({a, b}, {d, along(d, c.coin() ? 1.0 : 2.0, on_a - d)}, in_plane);
    });
    add("full_mantissa", [](DrawStream& c) -> Question {
      const LongPlane plane = LongPlane::of(c);
      const Point3d p = plane.point(c), q = plane.point(c), r = plane.point(c);
      const bool in_plane = c.coin();
      return seen({p, q}, {r, plane.point(c)}, in_plane);
    });
    add("rounding", [](DrawStream& c) -> Question {
      // The foot of b's end on a diagonal is half an odd step along: x is halfway between two doubles.
      const double x = halfway_number(c);
      const double odd = 1 + 2 * up_to(c, 7), far = one_to(c, 8);
      const Point3d end{x + odd, 0, hair(c)};
      return seen({{x, 0, 0}, {x + 64, 64, 0}}, {{end.x + far, -far, end.z}, end}, c.coin());
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      const bool in_plane = c.coin();
      return seen({{-1, 0, 0}, {0, 0, 0}}, {{step.x, step.y, hair(c)}, {step.x, 2 * step.y, 0}}, in_plane);
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question question = crossing_or_skew(c);
      if (auto* space = std::get_if<InSpace>(&question)) {
        auto& [a, b] = *space;
        Stretch{c}(a, b);
      }
      return question;
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const Point3d p = typed_point(c), q = typed_point(c), r = typed_point(c);
      const bool in_plane = c.coin();
      return seen({p, q}, {r, typed_point(c)}, in_plane);
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d p = subnormal_point(c), q = subnormal_point(c), r = subnormal_point(c);
      const Point3d last = c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c);
      return seen({p, q}, {r, last}, c.coin());
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c), q = point_of_full_range(c), r = point_of_full_range(c);
      const bool in_plane = c.coin();
      return seen({p, q}, {r, point_of_full_range(c)}, in_plane);
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), q = zero_point(c), r = zero_point(c), s = zero_point(c);
      const double x = up_to(c, 1), y = up_to(c, 1);
      return seen({p, x == 0 ? q : Point3d{1, q.y, q.z}}, {r, y == 0 ? s : Point3d{s.x, 1, s.z}}, c.coin());
    });
  }

  /// Segments that cross at (12, 12); moves the beginning of the first.
  static Question map_centre() { return InPlane{{{0.5, 0.5}, {24, 24}}, {{24, 0}, {12, 12}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static std::optional<Answers<TrueNumber>> as_near(const Question& question, const Answers<TrueNumber>& truth,
                                                    const Answers<double>& answer) {
    using Other = std::optional<Answers<TrueNumber>>;
    const auto of_alternative = [&]<class Segments>(const Segments& segments) -> Other {
      constexpr std::size_t which = std::is_same_v<Segments, InPlane> ? 0 : 1;
      const auto* const said = std::get_if<which>(&answer);
      if (said == nullptr) return std::nullopt;
      const auto& [a, b] = segments;
      return ::touchstone::oracle::as_near(a, b, std::get<which>(truth), said->on_a);
    };
    return visited(of_alternative, question);
  }

  static Hooks<segment_segment_distance> hooks() {
    return {.as_near = as_near, .map_centre = map_centre, .map_axes = map_axes, .laws = {.maps = Laws::Maps::axes}};
  }

 private:
  /// Both leave a point, or pass it by, or end there; one of them on a parallel plane.
  static Question crossing_or_skew(DrawStream& c) {
    const LatticeLine line = LatticeLine::of(c);
    const Vector3d displacement =
        line.in_plane ? Vector3d{line.displacement.y, small_integer(c), 0} : lattice_normal(c, 6);
    const double height = line.in_plane ? 0.0 : small_integer(c, 3);
    const Segment3d a = segment_through(c, line.origin, line.displacement);
    return seen(a, segment_through(c, line.origin + height * cross(line.displacement, displacement), displacement),
                line.in_plane);
  }

  static InSpace in_space(DrawStream& c, const LatticeLine& line, const Vector3d& aside) {
    const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
    const Segment3d b = line.between(k, small_integer(c, 3));
    return {line.between(i, j), {b.a + aside, b.b + aside}};
  }
  static Question side_by_side(DrawStream& c, const LatticeLine& line, const Vector3d& aside) {
    const auto [a, b] = in_space(c, line, aside);
    return seen(a, b, line.in_plane);
  }

  static Question seen(const Segment3d& a, const Segment3d& b, bool in_plane) {
    if (!in_plane) return InSpace{a, b};
    return InPlane{without_z(a), without_z(b)};
  }
};

}  // namespace touchstone::catalogue::rows
