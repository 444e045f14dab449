// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/contact_state.h"

#include "proptests/contact_laws.h"

namespace touchstone::proptests::contact_state_tests {
namespace {

using Row = rows::contact_state;

constexpr auto separating = ContactState::separating, resting = ContactState::resting,
               colliding = ContactState::colliding;
constexpr MovingBodyd still{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

ContactState opposite(ContactState s) { return s == separating ? colliding : s == colliding ? separating : resting; }

constexpr Worked<Row> gives;

}  // namespace

LAW("contact_state: exchanged bodies with the opposite normal; the opposite normal alone; time turned back", a, b, p,
    n) {
  const ContactState state = ask(asked);
  const auto back = [](const auto& body) { return with_turn(with_velocity(body, -1.0 * body.velocity), -1.0); };
  return ask(Row::Question{b, a, p, -1.0 * n}) == state && ask(Row::Question{a, b, p, -1.0 * n}) == opposite(state) &&
         ask(Row::Question{b, a, p, n}) == opposite(state) &&
         ask(Row::Question{back(a), back(b), p, n}) == opposite(state);
}

LAW("contact_state: axes exchanged and turned; where space is turned over, turns change their sense") {
  const ContactState state = ask(asked);
  for (const AxisMap& map : axis_maps) {
    auto mapped = map(asked);
    auto& [a, b, p, n] = mapped;
    if (turns_over(map)) a = with_turn(a, -1.0), b = with_turn(b, -1.0);
    if (ask(mapped) != state) return false;
  }
  return true;
}

LAW("contact_state: the normal's length does not matter", a, b, p, n) {
  const ContactState state = ask(asked);
  const auto normals = same_plane(n);
  for (std::size_t i = 1; i < normals.size(); ++i)  // the first is the opposite one
    if (ask(Row::Question{a, b, p, normals[i]}) != state) return false;
  return !on_small_lattice(std::tuple(n)) || ask(Row::Question{a, b, p, 3.0 * n}) == state;
}

EXACT_LAW("contact_state: an observer who moves and turns sees the same", a, b, p, n) {
  return ask(std::tuple(as_seen(a), as_seen(b), p, n)) == ask(asked);
}

EXACT_LAW("contact_state: every point of a body may be called its position, if its velocity is that point's", a, b, p,
          n) {
  const ContactState state = ask(asked);
  return ask(std::tuple(around(a, p), b, p, n)) == state && ask(std::tuple(around(a, p), around(b, p), p, n)) == state;
}

TEST_CASE("contact_state: p. 74's states worked by hand") {
  const MovingBodyd a{{0, 1, 0}, {0, -1, 0}, {0, 0, 0}}, b{{0, -1, 0}, {0, 2, 0}, {0, 0, 0}};
  gives({a, b, {0, 0, 0}, {0, 1, 0}}, colliding, 9);
  gives({a, b, {0, 0, 0}, {0, -7, 0}}, separating, 9);
  gives({a, a, {5, 0, 0}, {0, 1, 0}}, resting, 0);
  // w x r = (0, 0, 1) x (2, 0, 0) = (0, 2, 0): the end of a bar that turns on the spot.
  const MovingBodyd bar{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}};
  gives({bar, still, {2, 0, 0}, {0, 1, 0}}, separating, 4);
  gives({bar, still, {-2, 0, 0}, {0, 1, 0}}, colliding, 4);
  gives({bar, still, {2, 0, 0}, {3, 0, 0}}, resting, 0);  // it slides
  gives({bar, still, {2, 0, 9}, {3, 4, 12}}, separating, Rational(64, 169));
  gives({still, bar, {2, 0, 0}, {0, 1, 0}}, colliding, 4);                             // b turns
  gives({bar, {{4, 0, 0}, {0, 0, 0}, {0, 0, -1}}, {2, 0, 0}, {0, 1, 0}}, resting, 0);  // wheels that mesh
  // A ball of radius 2 rolls: (1, 0, 0) x (0, -2, 0) = (0, 0, -2).
  const MovingBodyd ball{{0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
  gives({ball, still, {0, 0, 0}, {0, 1, 0}}, resting, 0);
  gives({ball, still, {0, 0, 0}, {0, 0, 1}}, resting, 0);
}

TEST_CASE("contact_state: rounding, huge, subnormal and negative zero") {
  const Rational t = exact(tiny);
  const auto moving = [](double y) { return MovingBodyd{{0, 0, 0}, {0, y, 0}, {0, 0, 0}}; };
  gives({moving(tiny), still, {0, 0, 0}, {0, tiny, 0}}, separating, Rational(t * t), "rounding");
  gives({moving(-tiny), moving(-0.0), {0, 0, 0}, {-0.0, greatest, 0}}, colliding, Rational(t * t));
  gives({moving(greatest), moving(-greatest), {0, 0, 0}, {0, 1, 0}}, separating,
        Rational(4 * exact(greatest) * exact(greatest)));
  gives({moving(greatest), moving(greatest), {greatest, 0, 0}, {0, 2, 0}}, resting, 0);
  // Of opposite places the way between them is twice the greatest number, and a turn of 2^-1024 makes it 2^-52 less
  // than 2.
  const MovingBodyd slow{{-greatest, 0, 0}, {0, -1, 0}, {0, 0, 0x1p-1024}};
  gives({slow, still, {greatest, 0, 0}, {0, 1, 0}}, separating,
        Rational((2 * exact(greatest) * power_of_two(-1024) - 1) * (2 * exact(greatest) * power_of_two(-1024) - 1)),
        "rounding");
  // 0.1 times 0.2 is not 0.02.
  gives({{{0, 0, 0}, {0.02, 0, 0}, {0, 0, 0.1}}, still, {0, 0.2, 0}, {1, 0, 0}}, colliding,
        Rational((exact(0.02) - exact(0.1) * exact(0.2)) * (exact(0.02) - exact(0.1) * exact(0.2))));
}

CONTRACT("contact_state: the formula in double keeps its contract", a, b, p, n) {
  if (!moderate(a, b, p, n)) return true;
  const Rational bound = 9 * unit() * dot(size_of(n), size_at(a, p) + size_at(b, p)),
                 square = dot(exactly(n), exactly(n));
  return Rational(*truth.margin * square) <= Rational(bound * bound) || answer == truth.answer;
}

TEST_CASE("contact_state: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::contact_state_tests
