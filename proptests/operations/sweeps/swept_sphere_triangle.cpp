// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_triangle.h"

#include "proptests/motion_laws.h"
#include "proptests/round_laws.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::proptests::swept_sphere_triangle_tests {
namespace {

using Row = rows::swept_sphere_triangle;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

constexpr Triangle3d right_angle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, around_origin{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
constexpr Worked<Row> worked;

}  // namespace

VELOCITIES_LAW("swept_sphere_triangle", 1)

LAW("swept_sphere_triangle: the corners may be exchanged", sphere, velocity, triangle) {
  const auto answer = ask(asked);
  const std::vector<Triangle3d> others = rewritten(triangle);
  return std::all_of(others.begin(), others.end(), [&](const Triangle3d& t) {
    return equal(ask(Row::Question{sphere, velocity, t}), answer);
  });
}

ROBUST_LAW("swept_sphere_triangle: at rest it is sphere_triangle, and a ball that meets it then does so at the start",
           sphere, velocity, triangle) {
  const bool meet = robust::sphere_triangle(sphere, triangle) != Contact::disjoint;
  const auto rest = ask(Row::Question{sphere, {0, 0, 0}, triangle}), answer = ask(asked);
  return rest.t.has_value() == meet && (!meet || (*rest.t == 0 && answer.t == 0));
}

ROBUST_LAW("swept_sphere_triangle: a triangle of one point is a ball of radius 0", sphere, velocity, triangle) {
  const Point3d& p = triangle.a;
  return equal(ask(Row::Question{sphere, velocity, {p, p, p}}),
               robust::swept_sphere_sphere(sphere, {p, 0}, velocity, {0, 0, 0}));
}

ROBUST_LAW("swept_sphere_triangle: no corner is met before it", sphere, velocity, triangle) {
  const auto answer = ask(asked);
  for (const Point3d& p : {triangle.a, triangle.b, triangle.c}) {
    const auto corner = robust::swept_sphere_sphere(sphere, {p, 0}, velocity, {0, 0, 0});
    if (corner.t && (!answer.t || *corner.t < *answer.t)) return false;
  }
  return true;
}

TEST_CASE("swept_sphere_triangle: to the face, an edge and a corner, worked by hand") {
  // 6 - 8 t = 2; the path has to be moved by 1 to miss the triangle: 2^2 + 1
  worked({{{1, 1, 6}, 2}, {0, 0, -8}, right_angle}, at(Rational(1, 2)), 5);
  worked({{{1, 1, -6}, 2}, {0, 0, 8}, right_angle}, at(Rational(1, 2)), 5);   // from the other side
  worked({{{1, 1, 6}, 2}, {0, 0, -3}, right_angle}, misses, 5);               // short of it: 3^2 - 2^2
  worked({{{1, 1, 6}, 2}, {0, 0, 3}, right_angle}, misses, 32);               // away: 6^2 - 2^2
  worked({{{2, -8, 0}, 3}, {0, 10, 0}, right_angle}, at(Rational(1, 2)), 9);  // in the plane, to an edge
  worked({{{2, -6, 8}, 5}, {0, 6, -8}, right_angle}, at(Rational(1, 2)), 25);
  // Beyond the edge by (3 - 3 t, 3): 9 (1 - t)^2 + 9 = 16; nearest 3^2
  worked({{{2, -3, 3}, 4}, {0, 3, 0}, right_angle}, at(Surd(Rational(1), Rational(-1, 3), 7)), 7);
  // Beyond the corner by (2, 4, 4) (1 - t), which is 6 (1 - t) long
  worked({{{-2, -4, 4}, 3}, {2, 4, -4}, right_angle}, at(Rational(1, 2)), 9);
  worked({{{5, 5, 6}, 2}, {0, 0, -12}, right_angle}, misses, 14);  // past the long edge by 6 / sqrt(2): 18 - 4
}

TEST_CASE("swept_sphere_triangle: touching is a hit: grazing, sliding, at the start and at the end") {
  worked({{{2, 1, 7}, 5}, {0, -8, -6}, right_angle}, at(Rational(1, 2)), 0);  // by (-1 + 8 t, 7 - 6 t): (3, 4)
  worked({{{1, -3, 2}, 2}, {0, 6, 0}, right_angle}, at(Rational(1, 2)), 0);   // over the face: (3 - 6 t)^2 + 4 = 4
  worked({{{-3, -2, 0}, 2}, {6, 0, 0}, right_angle}, at(Rational(1, 2)), 0);  // along an edge, from its corner on
  worked({{{1, 1, 6}, 2}, {0, 0, -4}, right_angle}, at(Rational(1)), 0);
  worked({{{1, 1, 2}, 2}, {0, 0, 1}, right_angle}, at(Rational(0)), 0);   // they part
  worked({{{1, 1, 2}, 2}, {1, 0, 0}, right_angle}, at(Rational(0)), 0);   // along the face
  worked({{{1, 1, 2}, 2}, {0, 0, -1}, right_angle}, at(Rational(0)), 3);  // deeper: 4 - 1
  worked({{{1, 1, 0}, 1}, {0, 0, 0}, right_angle}, at(Rational(0)), 1);   // its center is in the triangle
}

TEST_CASE("swept_sphere_triangle: points, and triangles that are segments and points") {
  worked({{{1, 1, 6}, 0}, {0, 0, -12}, right_angle}, at(Rational(1, 2)), 1);  // 1 from two edges
  worked({{{-1, 1, 0}, -0.0}, {2, 0, 0}, right_angle}, at(Rational(1, 2)), 0);
  worked({{{-1, -1, 0}, 0}, {2, 2, 0}, right_angle}, at(Rational(1, 2)), 0);  // into a corner
  worked({{{6, 8, 2}, 5}, {-6, -8, 0}, {{0, 0, 0}, {0, 0, 4}, {0, 0, 2}}}, at(Rational(1, 2)), 25);
  worked({{{0, 0, 9}, 1}, {0, 0, -8}, {{0, 0, 0}, {0, 0, 4}, {0, 0, 2}}}, at(Rational(1, 2)), 1);
  worked({{{-3, 2, 2}, 1}, {8, 0, 0}, {{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}}, at(Rational(1, 2)), 1);
}

TEST_CASE("swept_sphere_triangle: rounding, huge and subnormal") {
  // 2^54 + 1 and 2^54
  worked({{{1, 0x1p27, 0}, 0x1p27}, {0, 0, 0}, {{0, 0, 0}, {-1, -1, 0}, {-1, -1, 1}}}, misses, 1, "rounding");
  worked({{{0, 0, 3 * tiny}, tiny}, {0, 0, -4 * tiny}, around_origin}, at(Rational(1, 2)),
         Rational(2 * exact(tiny) * exact(tiny)));
  worked({{{0, 0, huge}, huge}, {0, 0, 0}, around_origin}, at(Rational(0)), 0, "rounding");
}

TEST_CASE("swept_sphere_triangle: numbers are refused first, then the radius") {
  refused<Row>({{{0, 0, 0}, -1}, {0, infinity, 0}, right_angle}, "velocity[1]", "finite number");
  refused<Row>({{{0, 0, 0}, -1}, {0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, {0, not_a_number, 0}}}, "triangle[2][1]",
               "finite number");
  refused<Row>({{{0, 0, 0}, -1}, {0, 0, 0}, right_angle}, "sphere.radius", "radius >= 0");
}

TEST_CASE("swept_sphere_triangle: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::swept_sphere_triangle_tests
