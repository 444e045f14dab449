// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_aabb.h"

#include "proptests/motion_laws.h"
#include "robust/sweeps/swept_aabb_aabb.h"
#include "robust/sweeps/swept_sphere_plane.h"
#include "robust/sweeps/swept_sphere_sphere.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::proptests::swept_sphere_aabb_tests {
namespace {

using Row = rows::swept_sphere_aabb;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

constexpr Aabb3d cube{{0, 0, 0}, {4, 4, 4}};
constexpr Worked<Row> worked;

}  // namespace

VELOCITIES_LAW("swept_sphere_aabb", 1)

ROBUST_LAW("swept_sphere_aabb: at rest it is sphere_aabb, and a ball that meets the box then does so at the start",
           sphere, velocity, aabb) {
  const bool meet = robust::sphere_aabb(sphere, aabb) != Contact::disjoint;
  const auto rest = ask(Row::Question{sphere, {0, 0, 0}, aabb}), answer = ask(asked);
  return rest.t.has_value() == meet && (!meet || (*rest.t == 0 && answer.t == 0));
}

ROBUST_LAW("swept_sphere_aabb: a box of one point is a ball of radius 0", sphere, velocity, aabb) {
  const Point3d& p = aabb.min;
  return equal(ask(Row::Question{sphere, velocity, {p, p}}),
               robust::swept_sphere_sphere(sphere, {p, 0}, velocity, {0, 0, 0}));
}

ROBUST_LAW("swept_sphere_aabb: a ball of radius 0 is a box of one point", sphere, velocity, aabb) {
  const Point3d& c = sphere.center;
  return equal(ask(Row::Question{{c, 0}, velocity, aabb}), robust::swept_aabb_aabb(Aabb3d{c, c}, aabb, velocity));
}

ROBUST_LAW("swept_sphere_aabb: over a face that has no end, it is swept_sphere_plane", sphere, velocity, aabb) {
  const double side = aabb.max.x, most = greatest;
  const Point3d end = sphere.center + velocity;
  if (sphere.center.x < side || !finite(end.y, end.z)) return true;
  return equal(ask(Row::Question{sphere, velocity, {{-most, -most, -most}, {side, most, most}}}),
               robust::swept_sphere_plane(sphere, velocity, {{1, 0, 0}, -side}));
}

TEST_CASE("swept_sphere_aabb: to a face, an edge and a corner, worked by hand") {
  // 6 - 8 t = 2; it gets 2 deep: 2^2 + 2^2
  worked({{{-6, 2, 2}, 2}, {8, 0, 0}, cube}, at(Rational(1, 2)), 8);
  worked({{{-6, 2, 2}, 2}, {3, 0, 0}, cube}, misses, 5);    // short of it: 3^2 - 2^2
  worked({{{-6, 2, 2}, 2}, {-1, 0, 0}, cube}, misses, 32);  // away: 6^2 - 2^2
  worked({{{-6, 2, 2}, 2}, {0, 0, 0}, cube}, misses, 32);   // at rest
  worked({{{-3, 7, 2}, 2}, {10, 0, 0}, cube}, misses, 5);   // past a face: 3^2 - 2^2
  // Beyond the edge by (6, 8) (1 - t), which is 10 (1 - t) long; the center ends on it.
  worked({{{10, 12, 2}, 5}, {-6, -8, 0}, cube}, at(Rational(1, 2)), 25);
  // Beyond it by (3 - 3 t, 3): 9 (1 - t)^2 + 9 = 16; nearest 3^2
  worked({{{7, 7, 2}, 4}, {-3, 0, 0}, cube}, at(Surd(Rational(1), Rational(-1, 3), 7)), 7);
  // By (4 - 4 t, 4 t): 32 t^2 - 32 t + 7 = 0; nearest 8
  worked({{{8, 4, 2}, 3}, {-4, 4, 0}, cube}, at(Surd(Rational(1, 2), Rational(-1, 8), 2)), 1);
  worked({{{8, 4, 2}, 2}, {-4, 4, 0}, cube}, misses, 4);
  // Beyond the corner by (2, 4, 4) (1 - t), which is 6 (1 - t) long; and by (2, 2, 2 - 4 t): 8 + 1 = 9, nearest 8
  worked({{{6, 8, 8}, 3}, {-2, -4, -4}, cube}, at(Rational(1, 2)), 9);
  worked({{{6, 6, 6}, 3}, {0, 0, -4}, cube}, at(Rational(1, 4)), 1);
}

TEST_CASE("swept_sphere_aabb: touching is a hit: grazing, sliding, at the start and at the end") {
  worked({{{3, 11, 2}, 5}, {8, -6, 0}, cube}, at(Rational(1, 2)), 0);  // by (-1 + 8 t, 7 - 6 t): (3, 4)
  worked({{{-3, 2, 6}, 2}, {6, 0, 0}, cube}, at(Rational(1, 2)), 0);   // over the top: (3 - 6 t)^2 + 4 = 4
  worked({{{-1, 8, 7}, 5}, {2, 0, 0}, cube}, at(Rational(1, 2)), 0);   // over an edge, by (4, 3)
  worked({{{7, 8, 2}, 4}, {-3, 0, 0}, cube}, at(Rational(1)), 0);      // over a face at the very end
  worked({{{-6, 2, 2}, 2}, {4, 0, 0}, cube}, at(Rational(1)), 0);
  worked({{{7, 8, 2}, 5}, {1, 1, 0}, cube}, at(Rational(0)), 0);   // they part
  worked({{{7, 8, 2}, 5}, {0, 0, 1}, cube}, at(Rational(0)), 0);   // along the edge
  worked({{{7, 8, 2}, 5}, {-3, 0, 0}, cube}, at(Rational(0)), 9);  // deeper: 25 - 16
  worked({{{2, 2, 2}, 1}, {1, 0, 0}, cube}, at(Rational(0)), 5);   // within, 2 deep on all axes: 1 + 4
}

TEST_CASE("swept_sphere_aabb: points, and boxes that are rectangles, segments and points") {
  worked({{{-2, -2, 2}, 0}, {4, 4, 0}, cube}, at(Rational(1, 2)), 4);  // through an edge, 2 deep
  worked({{{-1, 1, 2}, -0.0}, {2, -2, 0}, cube}, at(Rational(1, 2)), 0);
  worked({{{2, -3, 2}, 1}, {0, 4, 0}, {{0, 0, 0}, {4, 0, 4}}}, at(Rational(1, 2)), 2);  // 1 past it
  worked({{{2, -3, 2}, 0}, {0, 4, 0}, {{0, 0, 0}, {4, 0, 4}}}, at(Rational(3, 4)), 1);
  worked({{{6, 8, 2}, 5}, {-6, -8, 0}, {{0, 0, 0}, {0, 0, 4}}}, at(Rational(1, 2)), 25);
  worked({{{-3, 2, 2}, 1}, {8, 0, 0}, {{2, 2, 2}, {2, 2, 2}}}, at(Rational(1, 2)), 1);
}

TEST_CASE("swept_sphere_aabb: rounding, huge and subnormal") {
  const Rational square = exact(tiny) * exact(tiny);
  // 2^54 + 1 and 2^54
  worked({{{1, 0x1p27, 0}, 0x1p27}, {0, 0, 0}, {{-1, -1, -1}, {0, 0, 1}}}, misses, 1, "rounding");
  worked({{{3 * tiny, 0, 0}, tiny}, {-4 * tiny, 0, 0}, {{-1, -1, -1}, {0, 1, 1}}}, at(Rational(1, 2)),
         Rational(2 * square));
  worked({{{-huge, 0, 0}, huge}, {huge, 0, 0}, {{0, -1, -1}, {huge, 1, 1}}}, at(Rational(0)),
         Rational(exact(huge) * exact(huge)));
}

TEST_CASE("swept_sphere_aabb: numbers are refused first, then the radius, then the box") {
  const Aabb3d reversed{{0, 0, 0}, {1, -1, 1}};
  refused<Row>({{{0, 0, 0}, -1}, {0, 0, 0}, reversed}, "sphere.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, 1}, {0, 0, 0}, reversed}, "aabb.max[1]", "min <= max");
  refused<Row>({{{0, 0, 0}, -1}, {0, infinity, 0}, reversed}, "velocity[1]", "finite number");
}

TEST_CASE("swept_sphere_aabb: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::swept_sphere_aabb_tests
