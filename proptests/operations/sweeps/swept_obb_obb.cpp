// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_obb_obb.h"

#include "proptests/motion_laws.h"
#include "proptests/round_laws.h"
#include "robust/sweeps/swept_aabb_aabb.h"
#include "robust/volumes/obb_obb.h"

namespace touchstone::proptests::swept_obb_obb_tests {
namespace {

using Row = rows::swept_obb_obb;
using Answer = exact_answer_t<Row>;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Rational& t) { return {HitRelation::hit, t}; }

constexpr HalfAxes<double> unit_cube{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
/// Turned by the triple 3, 4, 5: it reaches 7 to each side on x and y, and 1 on z.
constexpr HalfAxes<double> turned{{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}};
constexpr Obb3d cube_at(const Point3d& center) { return {center, unit_cube}; }
constexpr Obb3d turned_at(const Point3d& center) { return {center, turned}; }
/// Above and below, their ridges along x and along y: only the axis of two edges, z, separates them.
constexpr Obb3d ridge_at(double z) { return {{0, 0, z}, {{4, 0, 0}, {0, 1, 1}, {0, -1, 1}}}; }
constexpr Obb3d other_ridge{{0, 0, 0}, {{0, 4, 0}, {1, 0, 1}, {-1, 0, 1}}};
constexpr Worked<Row> worked;

}  // namespace

VELOCITIES_LAW("swept_obb_obb", 2)

LAW("swept_obb_obb: half axes may be exchanged, and the boxes if a moves back", a, b, velocity) {
  const auto answer = ask(asked);
  return equal(ask(Row::Question{rewritten(a)[0], b, velocity}), answer) &&
         equal(ask(Row::Question{a, rewritten(b)[0], velocity}), answer) &&
         equal(ask(Row::Question{b, a, -1.0 * velocity}), answer);
}

ROBUST_LAW("swept_obb_obb: at rest it is obb_obb, and boxes that meet then do so at the start", a, b, velocity) {
  const bool meet = robust::obb_obb(a, b) != Contact::disjoint;
  const auto rest = ask(Row::Question{a, b, {0, 0, 0}}), answer = ask(asked);
  return rest.t.has_value() == meet && (!meet || (*rest.t == 0 && answer.t == 0));
}

ROBUST_LAW("swept_obb_obb: boxes along the axes are swept_aabb_aabb", a, b, velocity) {
  const auto straight = [](const Obb3d& box) {
    const auto length = [](double x) { return x == 0 ? 1 : std::fabs(x); };
    const auto& h = box.half_axes;
    return Obb3d{box.center, {{length(h.u.x), 0, 0}, {0, length(h.v.y), 0}, {0, 0, length(h.w.z)}}};
  };
  const Obb3d p = straight(a), q = straight(b);
  if (!on_lattice(std::tuple{p, q})) return true;
  const auto around = [](const Obb3d& box) {
    const Vector3d reach{box.half_axes.u.x, box.half_axes.v.y, box.half_axes.w.z};
    return Aabb3d{box.center + -1.0 * reach, box.center + reach};
  };
  return equal(ask(Row::Question{p, q, velocity}), robust::swept_aabb_aabb(around(p), around(q), velocity));
}

TEST_CASE("swept_obb_obb: faces, edges and corners, worked by hand") {
  // 10 - 16 t = 2 on x; at the end a is 6 past b's center, so the nearest way out is on y or z: 2
  worked({cube_at({-10, 0, 0}), cube_at({0, 0, 0}), {16, 0, 0}}, at(Rational(1, 2)), 4);
  worked({cube_at({-10, 0, 0}), cube_at({0, 0, 0}), {7, 0, 0}}, misses, 1);    // short of it by 1
  worked({cube_at({-10, 0, 0}), cube_at({0, 0, 0}), {-7, 0, 0}}, misses, 64);  // away: 10 - 2
  worked({cube_at({-10, 3, 0}), cube_at({0, 0, 0}), {20, 0, 0}}, misses, 1);   // past it by 1
  // The edge of a at 7 along x, to the face of b: 24 - 32 t = 8; on z they have to be moved by 2
  worked({turned_at({-24, 0, 0}), cube_at({0, 0, 0}), {32, 0, 0}}, at(Rational(1, 2)), 4);
  worked({turned_at({-24, 0, 0}), cube_at({0, 0, 0}), {15, 0, 0}}, misses, 1);
  // Two ridges: each reaches 2 on z
  worked({ridge_at(8), other_ridge, {0, 0, -8}}, at(Rational(1, 2)), 16);
  worked({ridge_at(8), other_ridge, {0, 0, -3}}, misses, 1);
}

TEST_CASE("swept_obb_obb: touching is a hit: grazing, sliding, at the start and at the end") {
  worked({cube_at({-10, 2, 0}), cube_at({0, 0, 0}), {16, 0, 0}}, at(Rational(1, 2)), 0);  // along a face
  worked({cube_at({-10, 2, 2}), cube_at({0, 0, 0}), {16, 0, 0}}, at(Rational(1, 2)), 0);  // along an edge
  worked({cube_at({-4, -2, 2}), cube_at({0, 0, 0}), {4, 4, 0}}, at(Rational(1, 2)), 0);   // from its corner
  worked({cube_at({-10, 0, 0}), cube_at({0, 0, 0}), {8, 0, 0}}, at(Rational(1)), 0);      // at the end
  worked({cube_at({-2, 0, 0}), cube_at({0, 0, 0}), {-1, 0, 0}}, at(Rational(0)), 0);      // they part
  worked({cube_at({-2, 0, 0}), cube_at({0, 0, 0}), {1, 0, 0}}, at(Rational(0)), 1);       // deeper, by 1
  worked({cube_at({0, 0, 0}), cube_at({0, 0, 0}), {0, 0, 0}}, at(Rational(0)), 4);
}

TEST_CASE("swept_obb_obb: half axes that are not at right angles") {
  // The half axis w of the first leans by 3: its lower face is right over the upper one of b. 8 - 12 t = 2
  const HalfAxes<double> leaning{{1, 0, 0}, {0, 1, 0}, {3, 0, 1}};
  worked({{{3, 0, 8}, leaning}, cube_at({0, 0, 0}), {0, 0, -12}}, at(Rational(1, 2)), 4);
  worked({{{6, 0, 2}, leaning}, cube_at({0, 0, 0}), {0, 0, 0}}, misses, 1);  // reaches 2 on x there, and b begins at 1
}

TEST_CASE("swept_obb_obb: rounding, huge and subnormal") {
  worked({{{0, 0, 3 * tiny}, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}},
          {{0, 0, 0}, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}},
          {0, 0, -2 * tiny}},
         at(Rational(1, 2)), Rational(exact(tiny) * exact(tiny)), "rounding");
  const HalfAxes<double> large{{huge, 0, 0}, {0, huge, 0}, {0, 0, huge}};
  worked({{{-huge, 0, 0}, large}, {{huge, 0, 0}, large}, {0, 0, 0}}, at(Rational(0)), 0, "rounding");
}

TEST_CASE("swept_obb_obb: numbers are refused first, then dependent half axes in order") {
  const Obb3d cube = cube_at({0, 0, 0}), flat{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  refused<Row>({flat, flat, {0, infinity, 0}}, "velocity[1]", "finite number");
  refused<Row>({flat, {{0, 0, not_a_number}, unit_cube}, {0, 0, 0}}, "b.center[2]", "finite number");
  refused<Row>({flat, flat, {0, 0, 0}}, "a.half_axes", "linearly independent");
  refused<Row>({cube, flat, {0, 0, 0}}, "b.half_axes", "linearly independent");
}

}  // namespace touchstone::proptests::swept_obb_obb_tests
