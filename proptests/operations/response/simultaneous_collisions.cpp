// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/simultaneous_collisions.h"

#include <algorithm>

#include "proptests/response_laws.h"
#include "robust/kernel/contacts/contact_system.h"
#include "robust/response/restitution_collision.h"

namespace touchstone::proptests::simultaneous_collisions_tests {
namespace {

using Row = rows::simultaneous_collisions;
using Exact = SimultaneousVelocities<Rational>;
using ExactBodies = std::vector<PointBody<Rational>>;
using ExactContacts = std::vector<BodyContact<Rational>>;

Exact possible(std::vector<Motion3> velocities) { return {Resolution::possible, std::move(velocities)}; }
const Exact impossible{Resolution::impossible, {}};

template <class R>
R parting(const BodyContact<R>& c, const Vector3<R>& a, const Vector3<R>& b) {
  return R(dot(c.normal, a - b));
}
Rational parting_before(const BodyContact<Rational>& c, const ExactBodies& bodies) {
  return parting(c, bodies[c.a].velocity, bodies[c.b].velocity);
}

/// Bodies of the inverse mass 1 along the x axis, each in contact with the next.
Row::Question row_of_balls(const std::vector<double>& speeds, double e) {
  Row::Question q{{}, {}, e};
  auto& [bodies, contacts, same_e] = q;
  for (Index i = 0; i < speeds.size(); ++i) {
    bodies.push_back({1, {speeds[i], 0, 0}});
    if (i > 0) contacts.push_back({i, i - 1, {1, 0, 0}});
  }
  return q;
}

/// Whether no contact parts, and immovable bodies stand still.
bool only_approach(const ExactBodies& bodies, const ExactContacts& contacts) {
  return std::none_of(contacts.begin(), contacts.end(), [&](const auto& c) { return parting_before(c, bodies) > 0; }) &&
         std::all_of(bodies.begin(), bodies.end(),
                     [](const auto& body) { return body.inverse_mass != 0 || same(body.velocity, none()); });
}

/// The sums of impulses at each body, from that guess of the contacts that push.
std::vector<Motion3> pushes_from(const Row::Question& q, bool (*guess)(std::size_t), bool& all_possible) {
  const auto& [bodies, contacts, e] = q;
  const auto system = robust::kernel::contact_system(bodies, contacts, e);
  std::vector<Motion3> sums(bodies.size(), none());
  for (const auto& part : robust::kernel::connected_parts(system)) {
    robust::kernel::Contacts guessed;
    std::copy_if(part.begin(), part.end(), std::back_inserter(guessed), guess);
    const auto found = robust::kernel::impulses_of(system, part, guessed);
    all_possible = all_possible && found.possible;
    for (std::size_t k = 0; k < found.contacts.size(); ++k) {
      const auto& [a, b, n, wanted] = system.contacts[found.contacts[k]];
      const Rational impulse = Rational(found.numerators[k]) / Rational(found.denominator);
      const Motion3 push = impulse * Motion3{Rational(n.x), Rational(n.y), Rational(n.z)};
      sums[a] = sums[a] + Rational(system.inverse_masses[a]) * push;
      sums[b] = sums[b] - Rational(system.inverse_masses[b]) * push;
    }
  }
  return sums;
}

}  // namespace

EXACT_LAW(
    "simultaneous_collisions: every demand is met, immovable bodies keep their velocity; without any, momentum is "
    "kept",
    bodies, contacts, e) {
  const Exact after = ask(asked);
  if (after.relation == Resolution::impossible) return !after.velocities;
  for (const auto& c : contacts) {
    const Rational before = parting_before(c, bodies), wanted = before < 0 ? Rational(-e * before) : Rational(0);
    if (parting(c, (*after.velocities)[c.a], (*after.velocities)[c.b]) < wanted) return false;
  }
  Motion3 gained = none();
  bool all_movable = true;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Motion3 change = (*after.velocities)[i] - bodies[i].velocity;
    const bool movable = bodies[i].inverse_mass != 0;
    if (movable) gained = gained + Rational(1 / bodies[i].inverse_mass) * change;
    else if (!same(change, none())) return false;
    all_movable = all_movable && movable;
  }
  return !all_movable || same(gained, none());
}

EXACT_LAW("simultaneous_collisions: where no contact parts, energy is not gained, and kept if e = 1", bodies, contacts,
          e) {
  const Exact after = ask(asked);
  if (!after.velocities || !only_approach(bodies, contacts)) return true;
  Rational gained;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Motion3 &v = bodies[i].velocity, &w = (*after.velocities)[i];
    if (bodies[i].inverse_mass != 0) gained += (dot(w, w) - dot(v, v)) / bodies[i].inverse_mass;
  }
  return e == 1 ? gained == 0 : gained <= 0;
}

EXACT_LAW("simultaneous_collisions: other observers agree, and what is resolved stays as it is") {
  const Exact answer = ask(asked);
  auto seen = asked, resolved = asked;
  const Motion3 shift{Rational(7, 3), Rational(-11), Rational(13, 5)};
  for (auto& body : std::get<0>(seen)) body.velocity = body.velocity + shift;
  const Exact elsewhere = ask(seen);
  if (elsewhere.relation != answer.relation) return false;
  if (!answer.velocities) return true;
  for (std::size_t i = 0; i < answer.velocities->size(); ++i) {
    if (!same((*elsewhere.velocities)[i], (*answer.velocities)[i] + shift)) return false;
    std::get<0>(resolved)[i].velocity = (*answer.velocities)[i];
  }
  return equal(ask(resolved), answer);
}

LAW("simultaneous_collisions: the order of contacts, their repetition, side and length do not matter") {
  const auto answer = ask(asked);
  auto other = asked;
  auto& contacts = std::get<1>(other);
  std::reverse(contacts.begin(), contacts.end());
  for (auto& contact : contacts) contact = catalogue::seen_from_b(contact);
  if (!equal(ask(other), answer)) return false;
  const auto once = contacts;
  contacts.insert(contacts.begin(), once.begin(), once.end());
  for (std::size_t i = 0; i < contacts.size(); i += 3)
    if (const auto longer_one = longer(contacts[i].normal, i % 2 == 0 ? 7 : -300)) contacts[i].normal = *longer_one;
  return equal(ask(other), answer);
}

LAW("simultaneous_collisions: masses have any unit") { return inverse_masses_have_any_unit(asked, ask); }

ROBUST_LAW(
    "simultaneous_collisions: one contact that approaches is a restitution_collision; one that does not, nothing",
    bodies, contacts, e) {
  const auto exactly = in_rationals(asked);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b, n] = contacts[i];
    const double wa = bodies[a].inverse_mass, wb = bodies[b].inverse_mass;
    if (validation::zero(wa) || validation::zero(wb)) continue;
    Velocitiesd expected{bodies[a].velocity, bodies[b].velocity};
    if (parting_before(std::get<1>(exactly)[i], std::get<0>(exactly)) < 0)
      expected = robust::restitution_collision({wb, wa}, expected, n, e);  // only the ratio of the masses counts
    const std::vector<Vector3d> found = ask(Row::Question{bodies, {contacts[i]}, e}).velocities.value();
    if (!equal(found[a], expected.first) || !equal(found[b], expected.second)) return false;
  }
  return true;
}

ROBUST_LAW("simultaneous_collisions: whatever contacts are guessed to push, the answer is the same") {
  bool possible = true, also = true, still = true;
  const auto none_of_them = pushes_from(
      asked, [](std::size_t) { return false; }, possible);
  const auto all = pushes_from(
      asked, [](std::size_t) { return true; }, also);
  const auto odd = pushes_from(
      asked, [](std::size_t i) { return i % 2 == 1; }, still);
  if (possible != also || possible != still) return false;
  const auto equals = [](const Motion3& v, const Motion3& w) { return same(v, w); };
  return !possible || (std::equal(all.begin(), all.end(), none_of_them.begin(), equals) &&
                       std::equal(all.begin(), all.end(), odd.begin(), equals));
}

TEST_CASE("simultaneous_collisions: Newton's cradle by hand") {
  // The first keeps a, the others leave together with w: a + 2 w = 5, w - a = 5 e.
  example<Row>(row_of_balls({5, 0, 0}, 1),
               possible({{Rational(-5, 3), 0, 0}, {Rational(10, 3), 0, 0}, {Rational(10, 3), 0, 0}}), "algorithm");
  example<Row>(row_of_balls({3, 0, 0}, 0), possible({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), "algorithm");
  example<Row>(row_of_balls({5, 0}, 1), possible({{0, 0, 0}, {5, 0, 0}}));
  // Both contacts at their demand: v0 = v1 - 4, v2 = v1 + 4.
  example<Row>(row_of_balls({4, 0, -4}, 1), possible({{-4, 0, 0}, {0, 0, 0}, {4, 0, 0}}), "algorithm");
  // The third is caught up with: a + 2 w = 6, w - a = 5. Energy grows from 26 to 258 / 9.
  example<Row>(row_of_balls({5, 0, 1}, 1),
               possible({{Rational(-4, 3), 0, 0}, {Rational(11, 3), 0, 0}, {Rational(11, 3), 0, 0}}), "algorithm");
}

TEST_CASE("simultaneous_collisions: walls, by hand") {
  const PointBodyd wall{0, {0, 0, 0}};
  // Right angles: each wall for itself.
  example<Row>({{{3, {-3, -4, 7}}, wall}, {{0, 1, {1, 0, 0}}, {0, 1, {0, 2, 0}}}, 0.5},
               possible({{Rational(3, 2), 2, 7}, {0, 0, 0}}));
  // x + y >= 1 and y - x >= 1
  example<Row>({{{3, {0, -1, 0}}, wall}, {{0, 1, {1, 1, 0}}, {1, 0, {1, -1, 0}}}, 1}, possible({{0, 1, 0}, {0, 0, 0}}));
  // The same contact three times.
  example<Row>({{wall, {1, {2, -1, 0}}}, {{1, 0, {0, 1, 0}}, {1, 0, {0, 3, 0}}, {0, 1, {0, -2, 0}}}, 0},
               possible({{0, 0, 0}, {2, 0, 0}}));
  // A body between walls that close on it, or just do not.
  example<Row>({{{0, {1, 0, 0}}, {1, {0, 0, 0}}, wall}, {{1, 0, {1, 0, 0}}, {2, 1, {1, 0, 0}}}, 0}, impossible,
               "algorithm");
  example<Row>({{{0, {1, 0, 0}}, {1, {0, 0, 0}}, {0, {1, 0, 0}}}, {{1, 0, {1, 0, 0}}, {2, 1, {1, 0, 0}}}, 0},
               possible({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}));
  example<Row>({{{0, {1, 0, 0}}, wall}, {{1, 0, {1, 0, 0}}}, 0}, impossible, "algorithm");
  example<Row>({{{0, {-1, 0, 0}}, wall}, {{1, 0, {1, 0, 0}}}, 0}, possible({{-1, 0, 0}, {0, 0, 0}}));
}

TEST_CASE("simultaneous_collisions: opposite normals allow no bounce") {
  const std::vector<PointBodyd> bodies{{1, {-1, 0, 0}}, {1, {0, 0, 0}}};
  const std::vector<BodyContactd> contacts{{0, 1, {1, 0, 0}}, {0, 1, {-2, 0, 0}}};
  example<Row>({bodies, contacts, 0}, possible({{Rational(-1, 2), 0, 0}, {Rational(-1, 2), 0, 0}}));
  example<Row>({bodies, contacts, tiny}, impossible, "algorithm");
}

TEST_CASE("simultaneous_collisions: nothing to do") {
  example<Row>({{}, {}, 1}, possible({}));
  example<Row>({{{0, {1, 2, 3}}, {1, {4, 5, 6}}}, {}, 0.5}, possible({{1, 2, 3}, {4, 5, 6}}));
  example<Row>(row_of_balls({0, 1, 1, 3}, 1), possible({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {3, 0, 0}}));
  const auto zeros = robust::simultaneous_collisions({{0, {-0.0, 0, 0}}, {1, {1, -0.0, -0.0}}}, {{1, 0, {1, 0, 0}}}, 0);
  CHECK((plus_zero((*zeros.velocities)[0].x) && plus_zero((*zeros.velocities)[1].y)));
}

TEST_CASE("simultaneous_collisions: a hundred contacts in a row") {
  std::vector<double> speeds(101);
  speeds[0] = 5;
  const auto struck = std::apply(robust::simultaneous_collisions, row_of_balls(speeds, 1)).velocities;
  const double rest = catalogue::nearest(Rational(10, 101));
  CHECK((*struck)[0].x == catalogue::nearest(Rational(10, 101) - 5));
  CHECK(std::all_of(struck->begin() + 1, struck->end(), [rest](const Vector3d& v) { return v.x == rest; }));
  for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i] = 0.1 - static_cast<double>(i);  // each presses on the next
  auto [bodies, contacts, e] = row_of_balls(speeds, 0);
  bodies[0] = {0, {0, 0, 0}};
  const auto landed = robust::simultaneous_collisions(bodies, contacts, e).velocities;
  CHECK(std::all_of(landed->begin(), landed->end(), [](const Vector3d& v) { return plus_zero(v.x); }));
}

TEST_CASE("simultaneous_collisions: indices of bodies that are not there, or the same twice, are refused") {
  const PointBodyd one{1, {0, 0, 0}};
  const BodyContactd contact{0, 1, {1, 0, 0}};
  refused<Row>({{one, one}, {contact, {2, 3, {0, 0, 0}}}, 2}, "contacts[1].a", "index of a body");
  refused<Row>({{one, one}, {contact, {1, 2, {0, 0, 0}}}, 2}, "contacts[1].b", "index of a body");
  refused<Row>({{one, one}, {{1, 1, {0, 0, 0}}}, 2}, "contacts[0].b", "another body than a");
}

EXACT_LAW("simultaneous_collisions: the formula is exactly right where no body that can move is in two contacts",
          bodies, contacts, e) {
  std::vector<int> touched(bodies.size());
  for (const auto& [a, b, n] : contacts) {
    if (bodies[a].inverse_mass == 0 && bodies[b].inverse_mass == 0) return true;
    for (const Index body : {a, b})
      if (bodies[body].inverse_mass != 0 && ++touched[body] > 1) return true;
  }
  return equal(reference::simultaneous_collisions(bodies, contacts, e), ask(asked));
}

ROBUST_LAW("simultaneous_collisions: the formula in double leaves what does not approach as it is", bodies, contacts,
           e) {
  for (const auto& c : contacts)
    if (!(parting(c, bodies[c.a].velocity, bodies[c.b].velocity) >= 0)) return true;
  const auto after = reference::simultaneous_collisions(bodies, contacts, e).velocities;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!equal((*after)[i], bodies[i].velocity)) return false;
  return true;
}

}  // namespace touchstone::proptests::simultaneous_collisions_tests
