// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/sphere_aabb.h"

#include "proptests/forward_error.h"
#include "robust/volumes/closest_point_on_aabb.h"
#include "robust/volumes/sphere_aabb.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::proptests::sphere_aabb_tests {
namespace {

using Row = rows::sphere_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

template <class Ball>
Ball with_radius(Ball ball, double radius) {
  ball.radius = radius;
  return ball;
}
bool flat(const Aabb2d& b) { return b.min.x == b.max.x || b.min.y == b.max.y; }
bool flat(const Aabb3d& b) { return b.min.x == b.max.x || b.min.y == b.max.y || b.min.z == b.max.z; }

/// Of the center from the box, and of the radius.
struct Squares {
  Rational distance, radius;
};
template <class Ball, class Box>
Squares squares(const Ball& ball, const Box& box) {
  const auto displacement = robust::closest_point_on_aabb(ball.center, box);  // exact
  const auto squared = [](double from, double to) {
    const Rational x(exact(to) - exact(from));
    return Rational(x * x);
  };
  Rational distance = squared(ball.center.x, displacement.x) + squared(ball.center.y, displacement.y);
  if constexpr (requires { displacement.z; }) distance += squared(ball.center.z, displacement.z);
  return {distance, squared(0, ball.radius)};
}

/// |S - R| exceeds its bound, of the contract.
template <class Ball, class Box>
bool certain(const Ball& ball, const Box& box) {
  const auto displacement = robust::closest_point_on_aabb(ball.center, box) - ball.center;
  if (!finite(dot(displacement, displacement), ball.radius * ball.radius)) return false;
  const auto [s, r] = squares(ball, box);
  const Rational u = unit();
  return abs(s - r) > (5 + 11 * u) * u * s + u * r + power_of_two(-1072);
}

constexpr Worked<Row> worked;

const Aabb2d square{{0, 0}, {4, 4}};
const Aabb3d cube{{0, 0, 0}, {4, 4, 4}};

}  // namespace

LAW("sphere_aabb: a ball that grows never loses contact, and one that touched overlaps a box with an interior", ball,
    box) {
  const double larger = catalogue::moved_by_ulps(ball.radius, 1);
  const Contact contact = ask(std::tuple(ball, box)), then = ask(std::tuple(with_radius(ball, larger), box));
  if (larger == ball.radius || contact == disjoint) return then >= contact;
  return then == (flat(box) ? touching : overlapping);
}

LAW("sphere_aabb: a point and a flat box overlap nothing", ball, box) {
  auto thin = box;
  thin.min.y = thin.max.y;
  return ask(std::tuple(with_radius(ball, 0), box)) != overlapping &&
         ask(std::tuple(with_radius(ball, -0.0), box)) != overlapping && ask(std::tuple(ball, thin)) != overlapping;
}

ROBUST_LAW("sphere_aabb: a ball meets the box exactly if it meets the nearest point, and that as balls do", ball, box) {
  using Ball = std::remove_cvref_t<decltype(ball)>;
  using Box = std::remove_cvref_t<decltype(box)>;
  const auto nearest = robust::closest_point_on_aabb(ball.center, box);
  const Contact contact = robust::sphere_sphere(ball, Ball{nearest, 0});
  return (ask(std::tuple(ball, box)) == disjoint) == (contact == disjoint) &&
         ask(std::tuple(ball, Box{nearest, nearest})) == contact;
}

LAW("sphere_aabb: a ball around a corner overlaps the box, unless one of them has no interior", ball, box) {
  using Ball = std::remove_cvref_t<decltype(ball)>;
  const Contact expected = ball.radius == 0 || flat(box) ? touching : overlapping;
  return ask(std::tuple(Ball{box.min, ball.radius}, box)) == expected &&
         ask(std::tuple(Ball{box.max, ball.radius}, box)) == expected;
}

LAW("sphere_aabb: a disc and a rectangle have the contact of a ball and a box over them", ball, box) {
  if constexpr (requires { ball.center.z; }) return true;
  else {
    const auto in_space = [&](double z, double low, double high) {
      return ask(InSpace{{{ball.center.x, ball.center.y, z}, ball.radius},
                         {{box.min.x, box.min.y, low}, {box.max.x, box.max.y, high}}});
    };
    const Contact contact = ask(std::tuple(ball, box));
    return in_space(0, -tiny, tiny) == contact && in_space(huge, 0, huge) == contact;
  }
}

TEST_CASE("sphere_aabb: p. 48-50's squares worked by hand, in the plane") {
  worked(InPlane{{{7, 8}, 4}, square}, disjoint, 9);      // beyond a corner by (3, 4): 25 - 16
  worked(InPlane{{{7, 8}, 5}, square}, touching, 0);      // 25 - 25
  worked(InPlane{{{7, 8}, 6}, square}, overlapping, 11);  // 36 - 25; the box is 4 wide: 16
  worked(InPlane{{{-2, 1}, 1}, square}, disjoint, 3);     // beyond a side: 4 - 1
  worked(InPlane{{{-2, 1}, 2}, square}, touching, 0);
  worked(InPlane{{{-2, 1}, 9}, square}, overlapping, 16);  // 81 - 4 is more than 16
  worked(InPlane{{{2, 2}, 1}, square}, overlapping, 1);    // within: 1 - 0
  worked(InPlane{{{1, 1}, 1}, square}, overlapping, 1);    // touches two sides from inside
  worked(InPlane{{{2, 2}, 9}, square}, overlapping, 16);   // the box within the disc
  worked(InPlane{{{4, 2}, 1}, square}, overlapping, 1);    // the center on a side
}

TEST_CASE("sphere_aabb: p. 48-50's squares worked by hand, in space") {
  worked(InSpace{{{5, 6, 6}, 2}, cube}, disjoint, 5);     // beyond a corner by (1, 2, 2): 9 - 4
  worked(InSpace{{{5, 6, 6}, 3}, cube}, touching, 0);     // 9 - 9
  worked(InSpace{{{5, 6, 6}, 4}, cube}, overlapping, 7);  // 16 - 9
  worked(InSpace{{{-3, 2, 8}, 5}, cube}, touching, 0);    // beyond an edge by (3, 0, 4)
  worked(InSpace{{{1, 2, -2}, 2}, cube}, touching, 0);    // beyond a face
  worked(InSpace{{{1, 2, -3}, 2}, cube}, disjoint, 5);    // z alone: 9 - 4
}

TEST_CASE("sphere_aabb: a flat box within the ball only touches it; the squares see an overlap") {
  worked(InPlane{{{0, 0}, 2}, {{-1, 1}, {1, 1}}}, touching, 0, "algorithm");          // 1 < 4
  worked(InSpace{{{0, 0, 0}, 2}, {{1, 1, 1}, {1, 1, 1}}}, touching, 0, "algorithm");  // a point: 3 < 4
  worked(InSpace{{{0, 0, 0}, 2}, {{-9, -9, 0}, {9, 9, 0}}}, touching, 0, "algorithm");
  worked(InPlane{{{0, 0}, 5}, {{3, 4}, {3, 4}}}, touching, 0);  // a point on the boundary
  worked(InPlane{{{0, 0}, 4}, {{3, 4}, {3, 4}}}, disjoint, 9);  // 25 - 16
}

TEST_CASE("sphere_aabb: a point in the box only touches it") {
  worked(InPlane{{{1, 2}, 0}, square}, touching, 0);
  worked(InPlane{{{1, 2}, -0.0}, square}, touching, 0);
  worked(InSpace{{{4, 4, 4}, 0}, cube}, touching, 0);  // its corner
  worked(InSpace{{{4, 4, 5}, 0}, cube}, disjoint, 1);
  worked(InSpace{{{2, 2, 2}, 0}, {{2, 2, 2}, {2, 2, 2}}}, touching, 0);
}

TEST_CASE("sphere_aabb: rounding, huge, subnormal and negative zero") {
  const Rational least = exact(tiny) * exact(tiny);
  worked(InPlane{{{0x1p27, 1}, 0x1p27}, {{-1, -1}, {0, 0}}}, disjoint, 1, "rounding");  // 2^54 + 1 rounds to 2^54
  worked(InPlane{{{2 * tiny, 0}, tiny}, {{-1, -1}, {0, 1}}}, disjoint, Rational(3 * least), "rounding");  // 4 - 1
  worked(InPlane{{{tiny, 0}, tiny}, {{-1, -1}, {0, 1}}}, touching, 0);
  worked(InPlane{{{0, 0}, tiny}, {{-1, -1}, {1, 1}}}, overlapping, least, "rounding");
  worked(InPlane{{{0, 0}, 1}, {{-tiny, -1}, {0, 1}}}, overlapping, least);  // its width
  worked(InPlane{{{1, -0.0}, 1}, {{-1, 0.0}, {-0.0, 1}}}, touching, 0);
  worked(InSpace{{{-huge, 0, 0}, huge}, {{0, -huge, -huge}, {huge, huge, huge}}}, touching, 0);
  worked(InSpace{{{-huge, 0, 0}, 1}, {{huge, -1, -1}, {huge, 1, 1}}}, disjoint,
         Rational(4 * exact(huge) * exact(huge) - 1));
}

CONTRACT("sphere_aabb: the formula in double keeps its contract", ball, box) {
  if (!certain(ball, box)) return true;
  const auto [s, r] = squares(ball, box);
  return answer == (s > r ? disjoint : overlapping) &&
         (answer == truth.answer || (truth.answer == touching && flat(box)));
}

}  // namespace touchstone::proptests::sphere_aabb_tests
