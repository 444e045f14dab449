// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/simulation_step.h"

#include <algorithm>

#include "proptests/response_laws.h"

namespace touchstone::proptests::simulation_step_tests {
namespace {

using Row = rows::simulation_step;
using namespace steps_in_the_plane;
using Exact = NextState<Rational>;
using Position3 = Point3<Rational>;
using State3 = BodyState<Rational>;
constexpr StepMotion all_motions[]{StepMotion::accelerate_then_move, StepMotion::move_then_accelerate,
                                   StepMotion::parabola};
constexpr StepTurn all_turns[]{StepTurn::before_move, StepTurn::after_move};

StepSettingsd settings_of(double e, StepTurn turn, double timestep = 1) {
  return {{0, 0, 0}, StepMotion::accelerate_then_move, e, timestep, turn};
}
State3 state(const Rational& x, const Rational& y, const Rational& vx, const Rational& vy) {
  return {{x, y, 0}, {vx, vy, 0}};
}

bool movable(const auto& body) { return body.inverse_mass != 0; }

/// Where bodies come to with the velocities of the answer, if the step does not change them.
Position3 flown(const StepBody<Rational>& body, const Motion3& before, const StepSettings<Rational>& settings) {
  const Rational share = settings.motion == StepMotion::parabola ? Rational(1, 2) : Rational(0);
  return body.sphere.center + settings.timestep * (before + Rational(share * settings.timestep) * settings.gravity);
}
/// What gravity adds to a velocity in a step.
template <class Body>
Motion3 fall_of(const Body& body, const StepSettings<Rational>& settings) {
  return movable(body) ? settings.timestep * settings.gravity : none();
}
/// The velocities with which contacts are found, and those that the response gives: each before gravity if that enters
/// afterwards.
std::vector<Motion3> velocities_met(const std::vector<StepBody<Rational>>& bodies,
                                    const StepSettings<Rational>& settings) {
  const bool fallen = settings.motion == StepMotion::accelerate_then_move || settings.turn == StepTurn::after_move;
  std::vector<Motion3> found;
  for (const auto& body : bodies) found.push_back(fallen ? body.velocity + fall_of(body, settings) : body.velocity);
  return found;
}
std::vector<Motion3> velocities_given(const Exact& answer, const std::vector<StepBody<Rational>>& bodies,
                                      const StepSettings<Rational>& settings) {
  const bool falls_later =
      settings.motion != StepMotion::accelerate_then_move && settings.turn == StepTurn::before_move;
  std::vector<Motion3> found;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    found.push_back(falls_later ? answer.bodies[i].velocity - fall_of(bodies[i], settings) : answer.bodies[i].velocity);
  return found;
}
/// Where contacts are found.
std::vector<Position3> ends_of(const std::vector<StepBody<Rational>>& bodies, const StepSettings<Rational>& settings) {
  std::vector<Position3> found;
  const bool fallen = settings.motion == StepMotion::accelerate_then_move;
  for (const auto& body : bodies) {
    const Motion3 v = fallen ? body.velocity + fall_of(body, settings) : body.velocity;
    found.push_back(movable(body) ? flown(body, v, settings) : body.sphere.center);
  }
  return found;
}
/// Along the normal of a contact.
Rational parting(const IndexPair& contact, const std::vector<Motion3>& v, const std::vector<Position3>& ends,
                 const std::vector<Plane<Rational>>& walls) {
  const auto& [i, j] = contact;
  if (j >= v.size()) return dot(walls[j - v.size()].normal, v[i]);
  return dot(ends[i] - ends[j], v[i] - v[j]);
}

/// The answer to the question with its bodies and walls in reverse order, as the answer to the question itself.
template <class R>
NextState<R> reversed_back(NextState<R> answer, std::size_t walls) {
  std::reverse(answer.bodies.begin(), answer.bodies.end());
  reverse_back(answer.contacts, answer.bodies.size(), walls);
  return answer;
}

}  // namespace

LAW("simulation_step: permuting bodies and walls permutes the answer, and changes nothing else", bodies, walls,
    settings) {
  return equal(reversed_back(ask(in_reverse_order(asked)), walls.size()), ask(asked));
}

LAW("simulation_step: masses have any unit") { return inverse_masses_have_any_unit(asked, ask); }

LAW("simulation_step: the length of a wall's normal does not matter") {
  return normals_of_walls_have_any_length(asked, ask);
}

LAW("simulation_step: a wall that is named twice is met twice, and changes nothing else") {
  auto other = asked;
  auto& walls = std::get<1>(other);
  if (walls.empty()) return true;
  walls.push_back(walls.front());
  auto answer = ask(other);
  const auto bodies = static_cast<Index>(answer.bodies.size()), last = static_cast<Index>(bodies + walls.size() - 1);
  std::erase_if(answer.contacts, [last](const IndexPair& contact) { return contact.j == last; });
  return equal(answer, ask(asked));
}

EXACT_LAW("simulation_step: contacts do not part before, meet their demand after, and stand in ascending order", bodies,
          walls, settings) {
  const Exact answer = ask(asked);
  const auto before = velocities_met(bodies, settings), after = velocities_given(answer, bodies, settings);
  const auto ends = ends_of(bodies, settings);
  const IndexPair* last = nullptr;
  for (const IndexPair& contact : answer.contacts) {
    if (last != nullptr && !(last->i < contact.i || (last->i == contact.i && last->j < contact.j))) return false;
    last = &contact;
    const Rational approach = -parting(contact, before, ends, walls);
    if (approach < 0 || parting(contact, after, ends, walls) < settings.restitution * approach) return false;
  }
  return true;
}

EXACT_LAW("simulation_step: the response gains no energy, and loses none if e = 1; momentum is kept without walls",
          bodies, walls, settings) {
  const Exact answer = ask(asked);
  const auto before = velocities_met(bodies, settings), after = velocities_given(answer, bodies, settings);
  Rational gained;
  Motion3 pushed = none();
  bool all_movable = walls.empty();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Motion3 change = after[i] - before[i];
    all_movable = all_movable && movable(bodies[i]);
    if (!movable(bodies[i]) && !same(change, none())) return false;
    if (!movable(bodies[i])) continue;
    const Rational mass = 1 / bodies[i].inverse_mass;
    gained += mass * (dot(after[i], after[i]) - dot(before[i], before[i]));
    pushed = pushed + mass * change;
  }
  if (all_movable && !same(pushed, none())) return false;
  return settings.restitution == 1 ? gained == 0 : gained <= 0;
}

EXACT_LAW("simulation_step: bodies in no contact fly freely, and the others come to where the law of motion says",
          bodies, walls, settings) {
  const Exact answer = ask(asked);
  const auto before = velocities_met(bodies, settings), after = velocities_given(answer, bodies, settings);
  const auto ends = ends_of(bodies, settings);
  std::vector<bool> met(bodies.size());
  for (const auto& [i, j] : answer.contacts) {
    met[i] = true;
    if (j < bodies.size()) met[j] = true;
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool moves_on = settings.turn == StepTurn::before_move && movable(bodies[i]);
    const Position3 expected = moves_on ? flown(bodies[i], after[i], settings) : ends[i];
    if (!(answer.bodies[i].position == expected)) return false;
    if (!met[i] && !(same(after[i], before[i]) && expected == ends[i])) return false;
  }
  return true;
}

EXACT_LAW("simulation_step: whoever flies along sees the same, where nothing stands still", bodies, walls, settings) {
  const bool all_move = std::all_of(bodies.begin(), bodies.end(), [](const auto& body) { return movable(body); });
  if (!walls.empty() || !all_move) return true;
  const Motion3 wind{Rational(7, 3), Rational(-11), Rational(13, 5)};
  auto seen = asked;
  for (auto& body : std::get<0>(seen)) body.velocity = body.velocity + wind;
  Exact expected = ask(asked);
  for (auto& [position, velocity] : expected.bodies)
    position = position + settings.timestep * wind, velocity = velocity + wind;
  return equal(ask(seen), expected);
}

EXACT_LAW("simulation_step: the formula is exactly right where no body that can move meets two others", bodies, walls,
          settings) {
  const auto ends = ends_of(bodies, settings);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    int met = 0;
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const Motion3 apart = ends[i] - ends[j];
      const Rational reach = bodies[i].sphere.radius + bodies[j].sphere.radius;
      met += i != j && dot(apart, apart) <= reach * reach;
    }
    for (const auto& [n, offset] : walls) {
      const Rational height = dot(n, ends[i] - Position3{0, 0, 0}) + offset, r = bodies[i].sphere.radius;
      met += height <= 0 || height * height <= r * r * dot(n, n);
    }
    if (movable(bodies[i]) && met > 1) return true;
  }
  return equal(reference::simulation_step(bodies, walls, settings), ask(asked));
}

TEST_CASE("simulation_step: free flight by hand, in three motions") {
  const StepBodyd thrown = ball(0, 0, 1, 1, 2);
  const auto falling = [](StepMotion motion, StepTurn turn) { return StepSettingsd{{0, -4, 0}, motion, 1, 0.5, turn}; };
  const Rational half(1, 2);
  for (const StepTurn turn : all_turns) {
    example<Row>({{thrown}, {}, falling(StepMotion::accelerate_then_move, turn)}, {{}, {state(half, 0, 1, 0)}});
    example<Row>({{thrown}, {}, falling(StepMotion::move_then_accelerate, turn)}, {{}, {state(half, 1, 1, 0)}});
    example<Row>({{thrown}, {}, falling(StepMotion::parabola, turn)}, {{}, {state(half, half, 1, 0)}});
    // Nothing pulls what never moves.
    for (const StepMotion motion : all_motions)
      example<Row>({{ball(3, 4, 1, 0, 0, 0)}, {ground}, falling(motion, turn)}, {{}, {state(3, 4, 0, 0)}});
  }
}

TEST_CASE("simulation_step: a ball meets the ground, by hand") {
  // It comes to y = 0, half behind the plane, and leaves at half its speed: from there, or from where it was.
  const Rational half(1, 2);
  example<Row>({{ball(0, 2, 1, 3, -2)}, {ground}, settings_of(0.5, StepTurn::after_move)},
               {{{0, 1}}, {state(3, 0, 3, 1)}});
  example<Row>({{ball(0, 2, 1, 3, -2)}, {ground}, settings_of(0.5, StepTurn::before_move)},
               {{{0, 1}}, {state(3, 3, 3, 1)}});
  // A touch is enough; the normal's length does not matter.
  example<Row>({{ball(0, 3, 1, 0, -2)}, {{{0, 3, 0}, 0}}, settings_of(1, StepTurn::after_move)},
               {{{0, 1}}, {state(0, 1, 0, 2)}});
  // Just not.
  const double above = std::nextafter(3.0, 4.0);
  example<Row>({{ball(0, above, 1, 0, -2)}, {ground}, settings_of(1, StepTurn::after_move)},
               {{}, {state(0, exact(above) - 2, 0, -2)}});
  // Gravity of the step is answered too with accelerate_then_move: v = -1 - 2 at y = 1.
  for (const StepTurn turn : all_turns) {
    const StepSettingsd settings{{0, -2, 0}, StepMotion::accelerate_then_move, 1, 1, turn};
    const Rational y = turn == StepTurn::after_move ? 1 : 7;
    example<Row>({{ball(0, 4, 1, 0, -1)}, {ground}, settings}, {{{0, 1}}, {state(0, y, 0, 3)}});
  }
  // With a parabola it comes to y = 4 - 1 - 1 = 2. What gravity adds is answered where the body is at the end; it is
  // added to the answer, v' = 1, where velocities change before: y = 4 + 1 - 1.
  for (const StepTurn turn : all_turns) {
    const StepSettingsd settings{{0, -2, 0}, StepMotion::parabola, 1, 1, turn};
    const bool after = turn == StepTurn::after_move;
    example<Row>({{ball(0, 4, 2, 0, -1)}, {ground}, settings},
                 {{{0, 1}}, {state(0, after ? 2 : 4, 0, after ? 3 : -1)}});
  }
  // It parts, or slides: the first is no contact, the second is one that changes nothing.
  example<Row>({{ball(0, -2, 1, 0, 1)}, {ground}, settings_of(1, StepTurn::before_move)}, {{}, {state(0, -1, 0, 1)}});
  example<Row>({{ball(0, 1, 1, 5, 0)}, {ground}, settings_of(1, StepTurn::before_move)},
               {{{0, 1}}, {state(5, 1, 5, 0)}});
  // A particle on the plane.
  example<Row>({{ball(0, 1, 0, 0, -1)}, {ground}, settings_of(0, StepTurn::after_move)},
               {{{0, 1}}, {state(0, 0, 0, 0)}});
}

TEST_CASE("simulation_step: two balls, by hand") {
  // Of one mass, head on: they exchange their velocities.
  example<Row>({{ball(-3, 0, 1, 1, 0), ball(1, 0, 1, -1, 0)}, {}, settings_of(1, StepTurn::after_move)},
               {{{0, 1}}, {state(-2, 0, -1, 0), state(0, 0, 1, 0)}});
  example<Row>({{ball(-3, 0, 1, 1, 0), ball(1, 0, 1, -1, 0)}, {}, settings_of(1, StepTurn::before_move)},
               {{{0, 1}}, {state(-4, 0, -1, 0), state(2, 0, 1, 0)}});
  // Inverse masses 1 and 3, e = 1/2, along (3, 4): the approach of 25 becomes 12.5, so that 37.5 / 4 of impulse along
  // the normal, over 25, go to the first, and thrice as much to the other.
  const Rational impulse = Rational(75, 2) / 4 / 25;
  example<Row>({{ball(-3, -4, 2, 3, 4, 1), ball(3, 4, 3, 0, 0, 3)}, {}, settings_of(0.5, StepTurn::after_move)},
               {{{0, 1}}, {state(0, 0, 3 - 3 * impulse, 4 - 4 * impulse), state(3, 4, 9 * impulse, 12 * impulse)}});
  // Against one that never moves.
  example<Row>({{ball(0, 0, 1, 0, 0, 0), ball(4, 0, 1, -2, 7)}, {}, settings_of(1, StepTurn::after_move, 0.0625)},
               {{}, {state(0, 0, 0, 0), state(Rational(31, 8), Rational(7, 16), -2, 7)}});
  example<Row>({{ball(0, 0, 1, 0, 0, 0), ball(4, 0, 1, -2, 0)}, {}, settings_of(0.5, StepTurn::after_move)},
               {{{0, 1}}, {state(0, 0, 0, 0), state(2, 0, 1, 0)}});
}

TEST_CASE("simulation_step: what is no contact") {
  // Centers coincide at the end; particles; two that never move; what passes within the step (p. 23, option 1).
  example<Row>({{ball(-1, 0, 1, 1, 0), ball(1, 0, 1, -1, 0)}, {}, settings_of(1, StepTurn::after_move)},
               {{}, {state(0, 0, 1, 0), state(0, 0, -1, 0)}});
  example<Row>({{ball(-1, 0, 0, 1, 0), ball(1, 0, -0.0, -1, 0)}, {}, settings_of(1, StepTurn::before_move)},
               {{}, {state(0, 0, 1, 0), state(0, 0, -1, 0)}});
  example<Row>({{ball(0, 0, 3, 0, 0, 0), ball(1, 0, 3, 0, 0, -0.0)}, {ground}, settings_of(1, StepTurn::after_move)},
               {{}, {state(0, 0, 0, 0), state(1, 0, 0, 0)}});
  example<Row>({{ball(-5, 0, 1, 10, 0), ball(0, 0, 1, 0, 0, 0)}, {}, settings_of(1, StepTurn::after_move)},
               {{}, {state(5, 0, 10, 0), state(0, 0, 0, 0)}});
  example<Row>({{}, {}, settings_of(1, StepTurn::after_move)}, {{}, {}});
  example<Row>({{}, {ground}, settings_of(1, StepTurn::before_move)}, {{}, {}});
}

TEST_CASE("simulation_step: several contacts at once, by hand") {
  const StepTurn turn = StepTurn::after_move;
  // Newton's cradle: a + 2 w = 3, w - a = 3. The balls on the right are at rest with each other, and in contact.
  const std::vector<StepBodyd> cradle{ball(-3, 0, 0.5, 3, 0), ball(1, 0, 0.5, 0, 0), ball(2, 0, 0.5, 0, 0)};
  const std::vector<IndexPair> in_a_row{{0, 1}, {1, 2}};
  example<Row>({cradle, {}, settings_of(1, turn)},
               {in_a_row, {state(0, 0, -1, 0), state(1, 0, 2, 0), state(2, 0, 2, 0)}}, "algorithm");
  example<Row>({cradle, {}, settings_of(1, StepTurn::before_move)},
               {in_a_row, {state(-4, 0, -1, 0), state(3, 0, 2, 0), state(4, 0, 2, 0)}}, "algorithm");
  // Two balls on each other land, and are at rest as a whole.
  example<Row>({{ball(0, 2, 1, 0, -1), ball(0, 4, 1, 0, -1)}, {ground}, settings_of(0, turn)},
               {{{0, 1}, {0, 2}}, {state(0, 1, 0, 0), state(0, 3, 0, 0)}}, "algorithm");
  // In a corner each wall answers for itself.
  example<Row>({{ball(3, 3, 1, -2, -2)}, {ground, {{2, 0, 0}, 0}}, settings_of(1, turn)},
               {{{0, 1}, {0, 2}}, {state(1, 1, 2, 2)}});
  // Walls that face each other, nearer than the ball is wide: it approaches one, and parts from the
  // other. The formula reverses it twice.
  example<Row>({{ball(0, 0, 3, 0, -1)}, {{{0, 1, 0}, 2}, {{0, -1, 0}, 2}}, settings_of(1, turn)},
               {{{0, 1}}, {state(0, -1, 0, 1)}}, "algorithm");
  // The wall that is named twice: the formula has answered it when the second one's turn comes.
  example<Row>({{ball(0, 2, 1, 0, -1)}, {ground, ground}, settings_of(1, turn)},
               {{{0, 1}, {0, 2}}, {state(0, 1, 0, 1)}}, "algorithm");
}

TEST_CASE("simulation_step: huge, subnormal and zeros") {
  const Rational most = exact(greatest), least = exact(tiny);
  example<Row>({{ball(0, 0, 1, greatest, 0)}, {}, settings_of(1, StepTurn::before_move, 2)},
               {{}, {state(2 * most, 0, most, 0)}});
  example<Row>({{ball(0, tiny, 0, 0, -tiny)}, {ground}, settings_of(1, StepTurn::after_move)},
               {{{0, 1}}, {state(0, 0, 0, least)}});
  // A third of the way: h v is half of the least number, and goes to the even one.
  example<Row>({{ball(0, 0, 0, tiny, 0)}, {}, settings_of(1, StepTurn::after_move, 0.5)},
               {{}, {state(least / 2, 0, least, 0)}});
  const StepSettingsd still = settings_of(0, StepTurn::before_move);
  const auto zeros =
      robust::simulation_step({ball(-0.0, 1, 1, -0.0, -1, 1), ball(-0.0, 0, 0, -0.0, 0, 0)}, {ground}, still);
  for (const auto& [position, velocity] : zeros.bodies)
    CHECK((plus_zero(position.x) && plus_zero(velocity.x) && plus_zero(velocity.y)));
}

}  // namespace touchstone::proptests::simulation_step_tests
