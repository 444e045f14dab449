// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/sphere_sphere.h"

#include "proptests/forward_error.h"
#include "proptests/space_laws.h"

namespace touchstone::proptests::sphere_sphere_tests {
namespace {

using Row = rows::sphere_sphere;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

template <class Ball>
bool is_point(const Ball& ball) {
  return ball.radius == 0;
}
template <class Ball>
Ball with_radius(Ball ball, double radius) {
  ball.radius = radius;
  return ball;
}

Sphere3d ball_of(const Circle2d& disc, double z) { return {{disc.center.x, disc.center.y, z}, disc.radius}; }

constexpr Worked<Row> worked;

}  // namespace

LAW("sphere_sphere: a ball overlaps itself, unless it is a point: then it touches itself", a) {
  return ask(std::tuple(a, a)) == (is_point(a) ? touching : overlapping);
}

LAW("sphere_sphere: a point overlaps nothing", a, b) {
  return (ask(std::tuple(a, b)) != overlapping || (!is_point(a) && !is_point(b))) &&
         ask(std::tuple(with_radius(a, 0), b)) != overlapping &&
         ask(std::tuple(a, with_radius(b, -0.0))) != overlapping;
}

LAW("sphere_sphere: a ball that grows never loses contact, and one that touched overlaps", a, b) {
  const double larger = catalogue::moved_by_ulps(a.radius, 1);
  const Contact contact = ask(std::tuple(a, b)), then = ask(std::tuple(with_radius(a, larger), b));
  if (larger == a.radius || contact == disjoint) return then >= contact;
  return then == (is_point(b) ? touching : overlapping);
}

LAW("sphere_sphere: only the sum of the radii counts, but for points", a, b) {
  if (!on_lattice(std::tuple(a, b)) || is_point(a) || is_point(b)) return true;
  const double sum = a.radius + b.radius;
  const Contact contact = ask(std::tuple(a, b));
  return ask(std::tuple(with_radius(a, b.radius), with_radius(b, a.radius))) == contact &&
         ask(std::tuple(with_radius(a, sum / 2), with_radius(b, sum / 2))) == contact &&
         ask(std::tuple(with_radius(a, 0), with_radius(b, sum))) == std::min<Contact>(contact, touching);
}

LAW("sphere_sphere: discs have the contact of balls with their centers and radii", a, b) {
  if constexpr (requires { a.center.z; }) return true;
  else {
    const Contact contact = ask(std::tuple(a, b));
    return ask(InSpace{ball_of(a, 0), ball_of(b, -0.0)}) == contact &&
           ask(InSpace{ball_of(a, huge), ball_of(b, huge)}) == contact;
  }
}

TEST_CASE("sphere_sphere: p. 44's squares worked by hand, in the plane") {
  const Circle2d disc{{0, 0}, 2};
  worked(InPlane{disc, {{3, 4}, 2}}, disjoint, 9);      // 25 - 16
  worked(InPlane{disc, {{3, 4}, 3}}, touching, 0);      // 25 - 25
  worked(InPlane{disc, {{3, 4}, 4}}, overlapping, 11);  // 36 - 25; 36 - 16 and 36 - 4 are more
  worked(InPlane{disc, {{0, 1}, 1}}, overlapping, 5);   // from inside: 9 - 1, 9 - 4 and 9 - 1
  worked(InPlane{disc, {{1, 0}, 9}}, overlapping, 40);  // within: 121 - 1, 121 - 4 and 121 - 81
  worked(InPlane{disc, disc}, overlapping, 12);         // 16 - 4
}

TEST_CASE("sphere_sphere: p. 44's squares worked by hand, in space") {
  const Sphere3d ball{{1, 1, 1}, 1};
  worked(InSpace{ball, {{2, 3, 3}, 1}}, disjoint, 5);     // 1 + 4 + 4 - 4
  worked(InSpace{ball, {{2, 3, 3}, 2}}, touching, 0);     // 9 - 9
  worked(InSpace{ball, {{2, 3, 3}, 3}}, overlapping, 7);  // 16 - 9; 16 - 9 and 16 - 1
  worked(InSpace{ball, {{1, 1, -2}, 2}}, touching, 0);
  worked(InSpace{ball, {{1, 1, -3}, 2}}, disjoint, 7);  // 16 - 9: z alone
}

TEST_CASE("sphere_sphere: a point inside of another ball only touches it; the squares see an overlap") {
  worked(InPlane{{{0, 0}, 2}, {{1, 1}, 0}}, touching, 0, "algorithm");  // 2 < 4
  worked(InPlane{{{0, 0}, -0.0}, {{1, 1}, 2}}, touching, 0, "algorithm");
  worked(InSpace{{{0, 0, 0}, 9}, {{0, 0, 0}, 0}}, touching, 0, "algorithm");
  worked(InPlane{{{0, 0}, 5}, {{3, 4}, 0}}, touching, 0);  // on the boundary
  worked(InPlane{{{0, 0}, 4}, {{3, 4}, 0}}, disjoint, 9);  // 25 - 16
  worked(InSpace{{{2, 2, 2}, 0}, {{2, 2, 2}, -0.0}}, touching, 0);
  worked(InSpace{{{2, 2, 2}, 0}, {{2, 2, 3}, 0}}, disjoint, 1);
}

TEST_CASE("sphere_sphere: rounding, huge, subnormal and negative zero") {
  const Rational least = exact(tiny) * exact(tiny);
  worked(InPlane{{{0, 0}, 0x1p27}, {{0x1p27, 1}, 0}}, disjoint, 1, "rounding");  // 2^54 + 1 rounds to 2^54
  worked(InPlane{{{0, 0}, tiny}, {{3 * tiny, 0}, tiny}}, disjoint, Rational(5 * least), "rounding");  // 9 - 4
  worked(InPlane{{{0, 0}, tiny}, {{2 * tiny, 0}, tiny}}, touching, 0);
  worked(InPlane{{{0, 0}, tiny}, {{tiny, 0}, tiny}}, overlapping, Rational(3 * least), "rounding");  // 4 - 1
  worked(InPlane{{{0, 0}, tiny}, {{0, 0}, 1}}, overlapping, Rational(2 * exact(tiny) + least));      // (1 + t)^2 - 1
  worked(InPlane{{{-0.0, 0.0}, 1}, {{0.0, -0.0}, 1}}, overlapping, 3);
  worked(InSpace{{{-huge, 0, 0}, huge}, {{huge, 0, 0}, huge}}, touching, 0);
  worked(InSpace{{{-huge, 0, 0}, 1}, {{huge, 0, 0}, 1}}, disjoint, Rational(4 * exact(huge) * exact(huge) - 4));
  worked(InSpace{{{0, 0, 0}, huge}, {{0, 0, 1}, 1}}, overlapping, Rational(2 * exact(huge) + 1));  // less huge^2
}

CONTRACT("sphere_sphere: the formula in double keeps its contract", a, b) {
  if (!certain(a, b)) return true;
  const auto [s, r] = squares(a, b);
  return answer == (s > r ? disjoint : overlapping) &&
         (answer == truth.answer || (truth.answer == touching && (is_point(a) || is_point(b))));
}

}  // namespace touchstone::proptests::sphere_sphere_tests
