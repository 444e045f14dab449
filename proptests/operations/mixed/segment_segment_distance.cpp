// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_segment_distance.h"

#include "proptests/closest_laws.h"
#include "robust/lines/segment_segment.h"
#include "robust/mixed/closest_point_on_segment.h"

namespace touchstone::proptests::segment_segment_distance_tests {
namespace {

using Row = rows::segment_segment_distance;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

template <class Segment>
Segment reversed(const Segment& s) {
  return {s.b, s.a};
}

/// In the plane, and the same in space.
void worked(const Segment2d& a, const Segment2d& b, const Point2<Rational>& on_a, const Point2<Rational>& on_b,
            const Rational& distance, const std::string& by_reference = "agree") {
  const Rational square(distance * distance), height(5);
  const auto up = [](const Point2d& p) { return Point3d{p.x, p.y, 5}; };
  example<Row>(InPlane{a, b}, ClosestPair2<oracle::Surd>{{on_a.x, on_a.y}, {on_b.x, on_b.y}, square, distance},
               by_reference);
  example<Row>(InSpace{{up(a.a), up(a.b)}, {up(b.a), up(b.b)}},
               ClosestPair3<oracle::Surd>{{on_a.x, on_a.y, height}, {on_b.x, on_b.y, height}, square, distance},
               by_reference);
}
constexpr RoundsTo<Row> rounds_to;

}  // namespace

LAW("segment_segment_distance: the distance does not depend on the order, or the directions, of both", a, b) {
  const auto found = ask(asked);
  for (const auto& other : {std::tuple(b, a), std::tuple(reversed(a), b), std::tuple(a, reversed(b))}) {
    const auto same = ask(other);
    if (square_of(same) != square_of(found) || distance_of(same) != distance_of(found)) return false;
  }
  return true;
}

ROBUST_LAW("segment_segment_distance: to a segment of length 0 it is that of a point", a, b) {
  using Segment = std::remove_cvref_t<decltype(a)>;
  for (const auto& p : {b.a, b.b}) {
    const auto of_point = robust::closest_point_on_segment(p, a);
    const auto found = ask(std::tuple(a, Segment{p, p})), turned = ask(std::tuple(Segment{p, p}, a));
    if (square_of(found) != of_point.squared_distance || square_of(turned) != of_point.squared_distance) return false;
    if (square_of(ask(asked)) > of_point.squared_distance) return false;
  }
  return true;
}

ROBUST_LAW("segment_segment_distance: segments of the plane that meet have the distance 0", a, b) {
  if constexpr (requires { a.a.z; }) return true;
  else return robust::segment_segment(a, b).relation == SegmentRelation::disjoint || distance_of(ask(asked)) == 0;
}

LENGTHS_LAW("segment_segment_distance")

LAW("segment_segment_distance: the formula is right in exact arithmetic, but for parallel segments", a, b) {
  if constexpr (requires { a.a.z; }) {
    const auto a0 = exact_point(a.a), a1 = exact_point(a.b), b0 = exact_point(b.a), b1 = exact_point(b.b);
    const Vector3<Rational> across = cross(a1 - a0, b1 - b0);
    if (sgn(dot(across, across)) == 0) return true;
    const auto [x, y] = reference::nearest_of_segments<Rational>(a0, a1, b0, b1);
    return catalogue::nearest(dot(x - y, x - y)) == rounded(square_of(ask(asked)));
  } else {
    return true;
  }
}

TEST_CASE("segment_segment_distance: crossing, apart, end to end, worked by hand") {
  const Segment2d s{{0, 0}, {10, 0}};
  worked(s, {{5, -5}, {5, 5}}, {5, 0}, {5, 0}, 0);     // crossing
  worked(s, {{5, 4}, {5, 9}}, {5, 0}, {5, 4}, 4);      // b's end over a
  worked({{5, 4}, {5, 9}}, s, {5, 4}, {5, 0}, 4);      // and the other way round
  worked(s, {{13, 4}, {14, 9}}, {10, 0}, {13, 4}, 5);  // end to end
  worked(s, {{-3, -4}, {-4, -9}}, {0, 0}, {-3, -4}, 5);
  worked(s, {{10, 0}, {12, 5}}, {10, 0}, {10, 0}, 0);  // a common end
  worked(s, {{2, 0}, {3, 7}}, {2, 0}, {2, 0}, 0);      // an end on the other
}

TEST_CASE("segment_segment_distance: in space, along the common perpendicular") {
  example<Row>(
      InSpace{{{0, 0, 0}, {10, 0, 0}}, {{3, 4, -5}, {3, 4, 5}}},
      ClosestPair3<oracle::Surd>{{Rational(3), {}, {}}, {Rational(3), Rational(4), {}}, Rational(16), Rational(4)});
  example<Row>(InSpace{{{0, 0, 0}, {2, 2, 0}}, {{2, 0, 7}, {0, 2, 7}}},
               ClosestPair3<oracle::Surd>{
                   {Rational(1), Rational(1), {}}, {Rational(1), Rational(1), Rational(7)}, Rational(49), Rational(7)});
  rounds_to(InSpace{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}, {1, 1, 2}}}, {0, 0, 0, 0, 1, 1, 2, 0x1.6a09e667f3bcdp+0});
}

TEST_CASE("segment_segment_distance: of parallel segments the point of a that is nearest to its beginning") {
  const Segment2d s{{0, 0}, {10, 0}};
  worked(s, {{2, 3}, {5, 3}}, {2, 0}, {2, 3}, 3, "invalid");
  worked(s, {{5, 3}, {2, 3}}, {2, 0}, {2, 3}, 3, "invalid");
  worked({{10, 0}, {0, 0}}, {{2, 3}, {5, 3}}, {5, 0}, {5, 3}, 3, "invalid");
  worked(s, {{-2, 3}, {5, 3}}, {0, 0}, {0, 3}, 3, "invalid");
  worked(s, {{13, 4}, {20, 4}}, {10, 0}, {13, 4}, 5, "invalid");
  worked(s, {{-20, 4}, {-3, 4}}, {0, 0}, {-3, 4}, 5, "invalid");
  worked(s, {{7, 0}, {20, 0}}, {7, 0}, {7, 0}, 0, "invalid");  // collinear
  worked(s, {{20, 0}, {13, 0}}, {10, 0}, {13, 0}, 3, "invalid");
  worked(s, {{0, 0}, {10, 0}}, {0, 0}, {0, 0}, 0, "invalid");
}

TEST_CASE("segment_segment_distance: a segment of length 0 is a point") {
  worked({{0, 0}, {10, 0}}, {{3, 4}, {3, 4}}, {3, 0}, {3, 4}, 4, "invalid");
  worked({{3, 4}, {3, 4}}, {{0, 0}, {10, 0}}, {3, 4}, {3, 0}, 4, "invalid");
  worked({{3, 4}, {3, 4}}, {{0, 0}, {-0.0, 0.0}}, {3, 4}, {0, 0}, 5, "invalid");
}

TEST_CASE("segment_segment_distance: rounding, huge and subnormal") {
  rounds_to(InPlane{{{0, 0}, {3 * tiny, 3 * tiny}}, {{0, 3 * tiny}, {3 * tiny, 0}}},
            {2 * tiny, 2 * tiny, 2 * tiny, 2 * tiny, 0, 0});  // they cross at 1.5 least numbers
  rounds_to(InPlane{{{-huge, 0}, {0, 0}}, {{huge, 0}, {greatest, 0}}}, {0, 0, huge, 0, infinity, huge});
  rounds_to(InPlane{{{-greatest, 0}, {-huge, 0}}, {{huge, 0}, {greatest, 0}}}, {-huge, 0, huge, 0, infinity, infinity});
}

CONTRACT("segment_segment_distance: the formula in double is never too short by more than its contract", a, b) {
  const auto extent = [](const auto& s, const auto& x) {
    const Rational u = unit();
    const std::vector<Rational> from = exact_coordinates(s.a), to = exact_coordinates(s.b), at = exact_coordinates(x);
    Rational sum;
    for (std::size_t k = 0; k < at.size(); ++k)
      sum += 3 * u * abs(to[k] - from[k]) + u * abs(at[k]) + power_of_two(-1074);
    return sum;
  };
  return std::visit(
      [&](const auto& found) {
        if constexpr (std::is_same_v<decltype(found.on_a), std::remove_cvref_t<decltype(a.a)>>) {
          bool defined = finite(found.squared_distance, found.distance);
          catalogue::for_each_number(found, [&](const double& number) { defined = defined && finite(number); });
          if (!defined) return true;
          // D* <= (D + 2^-536) / (1 - 4u) + e, by squares.
          const Rational most((exact(found.distance) + power_of_two(-536)) / (1 - 4 * unit()) + extent(a, found.on_a) +
                              extent(b, found.on_b));
          return square_of(truth.answer).rational_part() <= most * most;
        } else {
          return false;
        }
      },
      answer);
}

}  // namespace touchstone::proptests::segment_segment_distance_tests
