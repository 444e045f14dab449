// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/impact_step.h"

#include <algorithm>

#include "proptests/response_laws.h"

namespace touchstone::proptests::impact_step_tests {
namespace {

using Row = rows::impact_step;
using namespace steps_in_the_plane;
using oracle::Surd;
using Exact = ImpactStep<Surd>;
using State = BodyState<Surd>;
using Moments = std::vector<Moment<Surd>>;

State state(const Rational& x, const Rational& y, const Rational& vx, const Rational& vy) {
  return {{x, y, Rational(0)}, {vx, vy, Rational(0)}};
}
Exact finished(Moments moments, std::vector<State> bodies) {
  return {StepCourse::finished, std::move(moments), std::move(bodies)};
}

/// The answer to the question with its bodies and walls in reverse order, as the answer to the question itself.
template <class R>
ImpactStep<R> reversed_back(ImpactStep<R> answer, std::size_t bodies, std::size_t walls) {
  if (answer.bodies) std::reverse(answer.bodies->begin(), answer.bodies->end());
  for (auto& [t, contacts] : answer.moments) reverse_back(contacts, bodies, walls);
  return answer;
}

}  // namespace

LAW("impact_step: permuting bodies and walls permutes the answer, and changes nothing else", bodies, walls, restitution,
    timestep) {
  return equal(reversed_back(ask(in_reverse_order(asked)), bodies.size(), walls.size()), ask(asked));
}

LAW("impact_step: masses have any unit") { return inverse_masses_have_any_unit(asked, ask); }

LAW("impact_step: the length of a wall's normal does not matter") {
  return normals_of_walls_have_any_length(asked, ask);
}

EXACT_LAW("impact_step: moments and places do not depend on the unit of time", bodies, walls, restitution, timestep) {
  auto slower = asked;
  for (auto& body : std::get<0>(slower)) body.velocity = Rational(1, 1024) * body.velocity;
  std::get<3>(slower) = 1024 * timestep;
  Exact expected = ask(asked);
  const Surd unit(Rational(1, 1024));
  if (expected.bodies)
    for (auto& body : *expected.bodies) body.velocity = unit * body.velocity;
  return equal(ask(slower), expected);
}

EXACT_LAW(
    "impact_step: each moment has a contact, within the step, and does not come before another by more than a "
    "rounded clock",
    bodies, walls, restitution, timestep) {
  const Exact answer = ask(asked);
  Surd last(Rational(0));
  for (const auto& [t, contacts] : answer.moments) {
    const Surd rounding(exact(0x1p-52));
    if (contacts.empty() || t < last - rounding || t < Surd(Rational(0)) || t > Surd(Rational(1))) return false;
    last = t;
  }
  return answer.moments.size() <= most_moments;
}

EXACT_LAW("impact_step: a step in which nothing collides is free flight", bodies, walls, restitution, timestep) {
  const Exact answer = ask(asked);
  if (!answer.moments.empty()) return true;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [w, v, sphere] = bodies[i];
    const auto end = sphere.center + timestep * v;
    const auto& [at, after] = (*answer.bodies)[i];
    if (!(at == Point3<Surd>{end.x, end.y, end.z}) || !(after.x == Surd(v.x)) || !(after.y == Surd(v.y))) return false;
  }
  return true;
}

TEST_CASE("impact_step: a ball meets the ground, by hand") {
  const Rational half(1, 2);
  // 2 above it at 4 a step: half of the step is left, in which it rises at 2.
  example<Row>({{ball(0, 3, 1, 3, -4)}, {ground}, 0.5, 1}, finished({{half, {{0, 1}}}}, {state(3, 2, 3, 2)}));
  // At the start; at the end, where it is turned and stays; just not.
  example<Row>({{ball(0, 1, 1, 0, -2)}, {ground}, 1, 1}, finished({{Rational(0), {{0, 1}}}}, {state(0, 3, 0, 2)}));
  example<Row>({{ball(0, 3, 1, 0, -2)}, {{{0, 3, 0}, 0}}, 1, 1},
               finished({{Rational(1), {{0, 1}}}}, {state(0, 1, 0, 2)}));
  const double above = std::nextafter(3.0, 4.0);
  example<Row>({{ball(0, above, 1, 0, -2)}, {ground}, 1, 1}, finished({}, {state(0, exact(above) - 2, 0, -2)}));
  // It touches and parts, or slides; it is behind, and goes deeper, or comes out.
  example<Row>({{ball(0, 1, 1, 0, 2)}, {ground}, 1, 1}, finished({}, {state(0, 3, 0, 2)}));
  example<Row>({{ball(0, 1, 1, 5, 0)}, {ground}, 1, 1}, finished({}, {state(5, 1, 5, 0)}));
  example<Row>({{ball(0, -8, 1, 0, -1)}, {ground}, 0, 1}, finished({{Rational(0), {{0, 1}}}}, {state(0, -8, 0, 0)}));
  example<Row>({{ball(0, -8, 1, 0, 1)}, {ground}, 0, 1}, finished({}, {state(0, -7, 0, 1)}));
}

TEST_CASE("impact_step: two balls, by hand") {
  // A bullet of 1,024 a step and a ball of radius 1/4 that never moves: 3/4 to go.
  example<Row>({{ball(-1, 0, 0, 1024, 0), ball(0, 0, 0.25, 0, 0, 0)}, {}, 1, 1},
               finished({{Rational(3, 4096), {{0, 1}}}}, {state(Rational(-2047, 2), 0, -1024, 0), state(0, 0, 0, 0)}));
  // Past each other, 1 aside with a reach of 2: (4 - 4 t)^2 + 1 = 4. Then n = (-sqrt(3), -1), n . v = -4 sqrt(3), and
  // the impulse is sqrt(3): (4, 0) becomes (1, -sqrt(3)), and the other (3, sqrt(3)).
  const Surd t(Rational(1), Rational(-1, 4), Rational(3));
  const Rational root = exact(1.7320508075688772935), left = 1 - exact(0.56698729810778067662);
  example<Row>({{ball(-4, 0, 1, 4, 0), ball(0, 1, 1, 0, 0)}, {}, 1, 1},
               finished({{t, {{0, 1}}}},
                        {state(left - root, -left * root, 1, -root), state(3 * left, 1 + left * root, 3, root)}));
  // They graze; overlap and part; overlap and approach; coincide; are particles.
  example<Row>({{ball(-4, 0, 1, 8, 0), ball(0, 2, 1, 0, 0)}, {}, 1, 1},
               finished({}, {state(4, 0, 8, 0), state(0, 2, 0, 0)}));
  example<Row>({{ball(0, 0, 1, -1, 0), ball(1, 0, 1, 0, 0)}, {}, 1, 1},
               finished({}, {state(-1, 0, -1, 0), state(1, 0, 0, 0)}));
  example<Row>({{ball(0, 0, 1, 1, 0), ball(1, 0, 1, 0, 0)}, {}, 1, 1},
               finished({{Rational(0), {{0, 1}}}}, {state(0, 0, 0, 0), state(2, 0, 1, 0)}));
  example<Row>({{ball(0, 0, 1, 1, 0), ball(0, 0, 1, -1, 0)}, {}, 1, 1},
               finished({}, {state(1, 0, 1, 0), state(-1, 0, -1, 0)}));
  example<Row>({{ball(-1, 0, 0, 2, 0), ball(1, 0, 0, -2, 0)}, {}, 1, 1},
               finished({}, {state(1, 0, 2, 0), state(-1, 0, -2, 0)}));
}

TEST_CASE("impact_step: what is left of a velocity that all but cancels, by hand") {
  // They touch but for the least number d: t = 2 d / 9, where n = -(1 - 2 d / 9, 2 + 5 d / 9, 2 - 4 d / 9), and of the
  // velocity, which is -n but for that, (2, -5, 4) d / 9 is left.
  const double d = 5e-324;
  const ImpactStepd step =
      robust::impact_step({{3, {1, 2, 2}, {{0, -d, 0}, 0}}, {3, {0, 0, 0}, {{1, 2, 2}, 3}}}, {}, 1, 1);
  const auto truth =
      oracle::impact_step({{3, {1, 2, 2}, {{0, -d, 0}, 0}}, {3, {0, 0, 0}, {{1, 2, 2}, 3}}}, {}, 1.0, 1.0);
  const Vector3<Surd>& left = truth.answer.bodies->at(0).velocity;
  for (const auto& [number, ninths] : {std::pair{left.x, 2}, std::pair{left.y, -5}, std::pair{left.z, 4}})
    CHECK(abs(Rational(oracle::nearest_double(number * Surd(1 / exact(d))) * 9 - ninths)) < Rational(1, 1000));
  const Vector3d& v = step.bodies->at(0).velocity;
  CHECK(std::tuple{v.x, v.y, v.z} == std::tuple{0.0, -d, 0.0});
  CHECK(step.bodies->at(0).position == Point3d{0, -d, d});
}

TEST_CASE("impact_step: several contacts at one moment, by hand") {
  const Rational half(1, 2), third = exact(1.0 / 3);
  // Three in a row of which the last two touch: 2 becomes -2/3, 4/3, 4/3. The formula does not see the contact at rest.
  example<Row>(
      {{ball(0, 0, 0.5, 2, 0), ball(2, 0, 0.5, 0, 0), ball(3, 0, 0.5, 0, 0)}, {}, 1, 1},
      finished({{half, {{0, 1}, {1, 2}}}}, {state(1 - third, 0, -2 * third, 0), state(2 + 2 * third, 0, 4 * third, 0),
                                            state(3 + 2 * third, 0, 4 * third, 0)}),
      "algorithm");
  // Two pairs at one moment have nothing to do with each other.
  example<Row>({{ball(0, 0, 0.5, 2, 0), ball(2, 0, 0.5, 0, 0), ball(0, 9, 0.5, 2, 0), ball(2, 9, 0.5, 0, 0)}, {}, 1, 1},
               finished({{half, {{0, 1}, {2, 3}}}},
                        {state(1, 0, 0, 0), state(3, 0, 2, 0), state(1, 9, 0, 0), state(3, 9, 2, 0)}));
}

TEST_CASE("impact_step: two hundred balls in a row that touch, one of them moving, are answered by robust at once") {
  constexpr int n = 200;
  std::vector<StepBodyd> row;
  for (int i = 0; i < n; ++i) row.push_back(ball(i, 0, 0.5, i == 0 ? 2 : 0, 0));
  const ImpactStepd step = robust::impact_step(row, {}, 1, 0.5);
  REQUIRE(step.moments.size() == 1);
  CHECK(step.moments[0].contacts.size() == n - 1);
  // The others move together at u, away from the first at 2, and the sum is 2: n u - 2 = 2.
  REQUIRE(step.bodies.has_value());
  CHECK((*step.bodies)[0].velocity.x == -1.98);
  for (int i = 1; i < n; ++i) CHECK((*step.bodies)[i].velocity.x == 0.02);
}

TEST_CASE("impact_step: where a step is not finished") {
  // To and fro between x = 0 and x = 1: 1/64, then every 1/32.
  Moments moments;
  for (Index k = 0; k < most_moments; ++k) moments.push_back({Rational(2 * k + 1, 64), {{0, k % 2 == 0 ? 2u : 1u}}});
  const std::vector<Plane3d> both{{{1, 0, 0}, 0}, {{-1, 0, 0}, 1}};
  example<Row>({{ball(0.5, 0, 0, 32, 0)}, both, 1, 1}, {StepCourse::too_many_moments, moments, std::nullopt});
  // With half of the speed there are sixteen, the last of them in time; then nothing is left to collide with.
  moments.clear();
  for (Index k = 0; k < most_moments; ++k) moments.push_back({Rational(2 * k + 1, 32), {{0, k % 2 == 0 ? 2u : 1u}}});
  example<Row>({{ball(0.5, 0, 0, 16, 0)}, both, 1, 1}, finished(moments, {state(Rational(1, 2), 0, 16, 0)}));
  // Seven times the same slanted wall, met at the height sqrt(2) over x + y = 0; six are not too many.
  const Surd t(Rational(1), Rational(-1, 4), Rational(2));
  std::vector<Plane3d> slanted(7, Plane3d{{1, 1, 0}, 0});
  std::vector<IndexPair> contacts;
  for (Index k = 1; k <= 7; ++k) contacts.push_back({0, k});
  example<Row>({{ball(2, 2, 1, -2, -2)}, slanted, 1, 1}, {StepCourse::too_many_contacts, {{t, contacts}}, std::nullopt},
               "algorithm");
}

}  // namespace touchstone::proptests::impact_step_tests
