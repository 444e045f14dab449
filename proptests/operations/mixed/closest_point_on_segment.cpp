// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/closest_point_on_segment.h"

#include "proptests/closest_laws.h"
#include "robust/lines/point_on_segment.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::proptests::closest_point_on_segment_tests {
namespace {

using Row = rows::closest_point_on_segment;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

template <class Segment>
Segment reversed(const Segment& s) {
  return {s.b, s.a};
}
template <class A, class B>
bool same_numbers(const A& a, const B& b) {
  bool same = true;
  std::visit(
      [&same](const auto& x, const auto& y) {
        if constexpr (std::is_same_v<decltype(x), decltype(y)>) same = equal(x, y);
      },
      a, b);
  return same;
}

/// In the plane, and the same in space.
void worked(const Point2d& p, const Segment2d& s, const Point2<Rational>& nearest, const Rational& distance,
            const std::string& by_reference = "agree") {
  const Rational square(distance * distance);
  example<Row>(InPlane{p, s}, ClosestPoint2<oracle::Surd>{{nearest.x, nearest.y}, square, distance}, by_reference);
  example<Row>(InSpace{{p.x, p.y, -7}, {{s.a.x, s.a.y, -7}, {s.b.x, s.b.y, -7}}},
               ClosestPoint3<oracle::Surd>{{nearest.x, nearest.y, Rational(-7)}, square, distance}, by_reference);
}
constexpr RoundsTo<Row> rounds_to;

}  // namespace

LAW("closest_point_on_segment: a reversed segment has the same nearest point", p, s) {
  return same_numbers(ask(asked), ask(std::tuple(p, reversed(s))));
}

LAW("closest_point_on_segment: no end is nearer, and either is nearest to itself", p, s) {
  using Segment = std::remove_cvref_t<decltype(s)>;
  const auto found = ask(asked);
  return square_of(found) <= square_of(ask(std::tuple(p, Segment{s.a, s.a}))) &&
         square_of(found) <= square_of(ask(std::tuple(p, Segment{s.b, s.b}))) &&
         is_zero(distance_of(ask(std::tuple(s.a, s)))) && is_zero(distance_of(ask(std::tuple(s.b, s))));
}

LENGTHS_LAW("closest_point_on_segment")

LAW("closest_point_on_segment: in the plane it is what it is in space at any height", p, s) {
  if constexpr (requires { p.z; }) return true;
  else {
    const auto at = [](const Point2d& q) { return Point3d{q.x, q.y, huge}; };
    const auto flat = ask(asked), high = ask(InSpace{at(p), {at(s.a), at(s.b)}});
    return distance_of(flat) == distance_of(high) && square_of(flat) == square_of(high) &&
           std::get<0>(flat).point.x == std::get<1>(high).point.x &&
           std::get<0>(flat).point.y == std::get<1>(high).point.y;
  }
}

ROBUST_LAW("closest_point_on_segment: a point on the segment has the distance 0, and one at a distance is off", p, s) {
  if constexpr (requires { p.z; }) return true;
  else {
    const bool on = robust::point_on_segment(p, s).relation == Incidence::on;
    const auto found = ask(asked);
    return on ? distance_of(found) == 0 && equal(std::get<0>(found).point, p) : true;
  }
}

ROBUST_LAW("closest_point_on_segment: a ball of the distance, made a little smaller, does not reach either end", p, s) {
  if constexpr (requires { p.z; }) {
    const double distance = distance_of(ask(asked)), less = std::nextafter(distance, 0.0);
    if (!finite(distance) || distance == 0) return true;
    return robust::sphere_sphere(Sphere3d{p, less}, Sphere3d{s.a, 0}) == Contact::disjoint &&
           robust::sphere_sphere(Sphere3d{p, less}, Sphere3d{s.b, 0}) == Contact::disjoint;
  } else {
    return true;
  }
}

TEST_CASE("closest_point_on_segment: feet and ends worked by hand") {
  const Segment2d s{{0, 0}, {10, 0}};
  worked({3, 4}, s, {3, 0}, 4);     // within
  worked({-3, 4}, s, {0, 0}, 5);    // beyond a
  worked({13, -4}, s, {10, 0}, 5);  // beyond b
  worked({0, 7}, s, {0, 0}, 7);     // over a
  worked({10, 7}, s, {10, 0}, 7);   // over b
  worked({6, 0}, s, {6, 0}, 0);     // on it
  worked({12, 0}, s, {10, 0}, 2);   // on its line
  worked({0, 0}, s, {0, 0}, 0);     // its end
  // Along (8, 6) by (2 * 8 + 9 * 6) / 100.
  worked({2, 1}, {{0, -8}, {8, -2}}, {Rational(28, 5), Rational(-19, 5)}, 6);
}

TEST_CASE("closest_point_on_segment: in space, and where the distance has a root") {
  example<Row>(InSpace{{1, 3, 4}, {{-5, 0, 0}, {5, 0, 0}}},
               ClosestPoint3<oracle::Surd>{{Rational(1), {}, {}}, Rational(25), Rational(5)});
  rounds_to(InSpace{{1, 1, 0}, {{0, 0, 0}, {0, 0, 9}}}, {0, 0, 0, 2, 0x1.6a09e667f3bcdp+0});
  rounds_to(InPlane{{0, 1}, {{0, 0}, {1, 1}}}, {0.5, 0.5, 0.5, 0x1.6a09e667f3bcdp-1});
}

TEST_CASE("closest_point_on_segment: a segment of length 0 is a point, by which the formula divides 0") {
  worked({4, 6}, {{1, 2}, {1, 2}}, {1, 2}, 5, "invalid");
  worked({1, 2}, {{1, 2}, {1, 2}}, {1, 2}, 0, "invalid");
  worked({3, 4}, {{0.0, -0.0}, {-0.0, 0.0}}, {0, 0}, 5, "invalid");
}

TEST_CASE("closest_point_on_segment: rounding, huge and subnormal") {
  rounds_to(InPlane{{huge, huge}, {{0, 0}, {1, 0}}}, {1, 0, infinity, 0x1.92c80954c51f5p+1023});
  worked({0, tiny}, {{0, 0}, {2 * tiny, 0}}, {0, 0}, exact(tiny), "invalid");
  // The foot is at 1.5 least numbers, halfway, and goes to the even one.
  rounds_to(InPlane{{3 * tiny, 0}, {{0, 0}, {4 * tiny, 4 * tiny}}}, {2 * tiny, 2 * tiny, 0, 2 * tiny});
  // Half the last place of 2^52 + 1: the even neighbour, or with a hair the other.
  const double x = 0x1p52 + 1;
  rounds_to(InPlane{{x + 1, 0}, {{x, 0}, {x + 64, 64}}}, {0x1p52 + 2, 0.5, 0.5, 0x1.6a09e667f3bcdp-1});
  rounds_to(InPlane{{x + 1, -0x1p-60}, {{x, 0}, {x + 64, 64}}}, {x, 0.5, 0.5, 0x1.6a09e667f3bcdp-1});
}

CONTRACT("closest_point_on_segment: the formula in double keeps its contract", p, s) {
  return std::visit(
      [&](const auto& found) {
        if constexpr (std::is_same_v<decltype(found.point), std::remove_cvref_t<decltype(p)>>) {
          const SegmentBound bound(p, s.a, s.b, found.point);
          const Rational square = square_of(truth.answer).rational_part();
          return !bound.defined || (bound.keeps(found.point) &&
                                    keeps_distance(found.distance, found.squared_distance, square, bound.sum));
        } else {
          return false;
        }
      },
      answer);
}

}  // namespace touchstone::proptests::closest_point_on_segment_tests
