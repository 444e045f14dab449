// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/closest_point_on_obb.h"

#include "proptests/box_laws.h"
#include "robust/volumes/closest_point_on_aabb.h"
#include "robust/volumes/sphere_obb.h"

namespace touchstone::proptests::closest_point_on_obb_tests {
namespace {

using Row = rows::closest_point_on_obb;
using namespace worked_boxes;

void worked(const Point3d& p, const Obb3d& box, const Point3<Rational>& nearest, const Rational& square,
            const std::string& by_reference = "agree") {
  const oracle::Surd squared(square);
  example<Row>({p, box}, {{nearest.x, nearest.y, nearest.z}, squared, sqrt(squared)}, by_reference);
}

}  // namespace

LAW("closest_point_on_obb: a box that is written in another way has the same nearest point") {
  return equal(ask(in_another_order<1>(asked)), ask(asked));
}

LAW("closest_point_on_obb: a box that is twice as large is no farther", p, box) {
  const auto larger = twice_as_large(box);
  return !larger || ask(Row::Question{p, *larger}).squared_distance <= ask(asked).squared_distance;
}

ROBUST_LAW("closest_point_on_obb: a point that point_in_obb sees in the box is its own, and no other is", p, box) {
  const auto found = ask(asked);
  if (holds_point(box, p)) return found.distance == 0 && found.squared_distance == 0 && equal(found.point, p);
  return found.distance > 0 || !on_lattice(asked);
}

ROBUST_LAW("closest_point_on_obb: a box along the axes has the nearest point of closest_point_on_aabb", p, box) {
  const auto straight = straightened(box);
  if (!on_lattice(asked) || !straight) return true;
  return equal(ask(Row::Question{p, straight->obb}).point, robust::closest_point_on_aabb(p, straight->aabb));
}

ROBUST_LAW("closest_point_on_obb: a ball reaches the box if its radius is not less than the distance", p, box) {
  const double distance = ask(asked).distance, more = catalogue::moved_by_ulps(distance, 1),
               less = catalogue::moved_by_ulps(distance, -1);
  if (distance == 0 || distance >= greatest) return true;
  return robust::sphere_obb({p, more}, box) != Contact::disjoint &&
         robust::sphere_obb({p, less}, box) == Contact::disjoint;
}

LENGTHS_LAW("closest_point_on_obb")

LAW("closest_point_on_obb: at right angles the formula is right in exact arithmetic", p, box) {
  if (!has_right_angles(box)) return true;
  const Point3<Rational> x = reference::nearest_in_obb<Rational>(exact_point(p), exact_obb(box));
  const auto found = ask(asked).point;
  return catalogue::nearest(x.x) == rounded(found.x) && catalogue::nearest(x.y) == rounded(found.y) &&
         catalogue::nearest(x.z) == rounded(found.z);
}

TEST_CASE("closest_point_on_obb: faces, edges and corners worked by hand") {
  worked({1, -5, 1}, cube, {1, -2, 1}, 9);     // beyond a face
  worked({5, 6, 0}, cube, {2, 2, 0}, 25);      // beyond an edge by (3, 4)
  worked({3, 4, 4}, cube, {2, 2, 2}, 9);       // beyond a corner by (1, 2, 2)
  worked({1, 1, 0}, cube, {1, 1, 0}, 0);       // inside
  worked({2, -1, -0.0}, cube, {2, -1, 0}, 0);  // on a face
  worked({2, 2, 2}, cube, {2, 2, 2}, 0);       // a corner
  worked({3, 3, 0}, cube, {2, 2, 0}, 2);       // the root of 2 away
  worked({6, 8, 0}, turned, {3, 4, 0}, 25);    // beyond a face by (3, 4)
  worked({-8, 6, 13}, turned, {-4, 3, 1}, 160 + 9);
  worked({-8, 6, 1}, turned, {-4, 3, 1}, 25);
}

TEST_CASE("closest_point_on_obb: where half axes are not at right angles the point that the formula takes is another") {
  worked({6, 3, 0}, sheared, {6, 2, 0}, 1, "algorithm");  // over its top, from (4, 2) to (8, 2); takes (8, 2)
  // x - 3 y = -6 is 4 from its side, along (1, -3) / 10; it takes (0.6, 0.2).
  worked({0, 2, 0}, sheared, {Rational(2, 5), Rational(4, 5), 0}, Rational(8, 5), "algorithm");
  worked({0, 0.5, 0}, sheared, {0, Rational(1, 2), 0}, 0, "algorithm");  // inside; it takes (0.15, 0.05)
  worked({9, 3, 0}, sheared, {8, 2, 0}, 2);                              // beyond the end of both
}

TEST_CASE("closest_point_on_obb: huge, subnormal and rounding") {
  const Rational t = exact(tiny), square = 4 * t * t;
  worked({3 * tiny, 0, 0}, least, {t, 0, 0}, square, "invalid");  // tiny^2 is 0: 0 / 0
  const auto rounds_to = [](const Row::Question& question, const std::vector<double>& numbers) {
    CHECK(numbers_of(catalogue::ask_robust<Row>(question)) == numbers);
  };
  rounds_to({{huge, 0, 0}, cube}, {2, 0, 0, infinity, huge});
  const double x = 0x1p52 + 1;  // the foot of (x + 1, 0) is (x + 1/2, 1/2), a tie
  const Obb3d diagonal{{x + 31, 33, 0}, {{32, 32, 0}, {0, 0, 64}, {-1, 1, 0}}};
  rounds_to({{x + 1, 0, 0}, diagonal}, {0x1p52 + 2, 0.5, 0, 0.5, 0x1.6a09e667f3bcdp-1});
  rounds_to({{x + 1, -0x1p-60, 0}, diagonal}, {x, 0.5, 0, 0.5, 0x1.6a09e667f3bcdp-1});
}

TEST_CASE("closest_point_on_obb: numbers are refused first, then the half axes") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  refused<Row>({{0, 0, 0}, flat}, "obb.half_axes", "linearly independent");
  refused<Row>({{0, not_a_number, 0}, flat}, "point[1]", "finite number");
}

CONTRACT("closest_point_on_obb: the formula in double keeps its contract", p, box) {
  const ObbBound bound(p, box);
  if (!bound.defined) return true;
  const Vector3<Rational> beyond = exact_point(p) - bound.exactly;
  const Rational square = dot(beyond, beyond);
  if (!finite(catalogue::nearest(4 * square), answer.point.x, answer.point.y, answer.point.z)) return true;
  return within(answer.point.x, bound.exactly.x, bound.of_coordinate.x) &&
         within(answer.point.y, bound.exactly.y, bound.of_coordinate.y) &&
         within(answer.point.z, bound.exactly.z, bound.of_coordinate.z) &&
         keeps_distance(answer.distance, answer.squared_distance, square, bound.sum);
}

}  // namespace touchstone::proptests::closest_point_on_obb_tests
