// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_steps.h"

#include <string>

namespace touchstone::certify {

std::vector<Mover> movers(const json& value) {
  expect(value.is_array(), "bodies: a list");
  std::vector<Mover> found;
  for (const json& body : value) {
    const std::string name = numbered("bodies", found.size());
    only(body, name, {"inverse_mass", "velocity", "sphere"});
    const Rational w = number(body["inverse_mass"], name + ".inverse_mass");
    const Triple v = point_in_space(body["velocity"], name + ".velocity");
    expect(sgn(w) >= 0, name + ".inverse_mass: inverse mass >= 0");
    expect(sgn(w) != 0 || v == nothing, name + ".velocity: 0 where the inverse mass is 0");
    found.push_back({w, v, ball(body["sphere"], name + ".sphere")});
  }
  return found;
}

std::vector<Plane> planes(const json& value) {
  expect(value.is_array(), "walls: a list");
  std::vector<Plane> found;
  for (const json& wall : value) found.push_back(plane(wall, numbered("walls", found.size())));
  return found;
}

namespace {

struct Settings {
  Triple fall;  ///< the change of velocity by gravity in a step
  std::string motion;
  Rational restitution, timestep;
  bool before_move;
};
/// A body and another, or a wall: then `other` is after the bodies.
struct Met {
  std::size_t body, other;
  Triple normal;
  Rational parting;
};

/// One of the enumerators.
std::string choice(const json& value, const std::string& what, std::initializer_list<const char*> words) {
  bool known = false;
  for (const char* word : words) known = known || (value.is_string() && value == word);
  expect(known, what + ": no such word");
  return value.get<std::string>();
}

Settings settings_of(const json& value) {
  only(value, "settings", {"gravity", "motion", "restitution", "timestep", "turn"});
  const Triple gravity = point_in_space(value["gravity"], "settings.gravity");
  const std::string motion = choice(value["motion"], "settings.motion",
                                    {"accelerate_then_move", "move_then_accelerate", "parabola"}),
                    turn = choice(value["turn"], "settings.turn", {"before_move", "after_move"});
  const Rational e = restitution(value["restitution"], "settings.restitution"),
                 h = number(value["timestep"], "settings.timestep");
  expect(sgn(h) > 0, "settings.timestep: timestep > 0");
  return {h * gravity, motion, e, h, turn == "before_move"};
}

void accelerate(std::vector<Mover>& bodies, const Settings& settings) {
  for (Mover& body : bodies)
    if (body.moves()) body.velocity = body.velocity + settings.fall;
}

Triple end_of(const Mover& body, const Settings& settings) {
  if (!body.moves()) return body.ball.center;
  const Triple curve = Rational(1, 2) * settings.fall;
  const Triple mean = settings.motion == "parabola" ? body.velocity + curve : body.velocity;
  return along(body.ball.center, settings.timestep, mean);
}

/// All contacts at these ends, in ascending order.
std::vector<Met> contacts_at(const std::vector<Triple>& ends, const std::vector<Mover>& bodies,
                             const std::vector<Plane>& walls) {
  std::vector<Met> found;
  const auto take = [&](std::size_t i, std::size_t j, const Triple& normal, const Triple& relative) {
    const Rational parting = dot(normal, relative);
    if (sgn(parting) <= 0) found.push_back({i, j, normal, parting});
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Triple apart = ends[i] - ends[j];
      const Rational reach = bodies[i].ball.radius + bodies[j].ball.radius;
      const bool meet = dot(apart, apart) <= reach * reach;
      if (meet && !(apart == nothing) && (bodies[i].moves() || bodies[j].moves()))
        take(i, j, apart, bodies[i].velocity - bodies[j].velocity);
    }
    for (std::size_t k = 0; k < walls.size() && bodies[i].moves(); ++k) {
      const Rational height = walls[k].at(ends[i]), &r = bodies[i].ball.radius;
      const bool meet = sgn(height) <= 0 || height * height <= r * r * dot(walls[k].normal, walls[k].normal);
      if (meet) take(i, bodies.size() + k, walls[k].normal, bodies[i].velocity);
    }
  }
  return found;
}

void expect_listed(const Claim& claim, const std::vector<Met>& contacts) {
  const json& listed = claim.truth["contacts"];
  const auto is_place = [](const json& value, std::size_t place) {
    return value.is_number_unsigned() && value.get<std::size_t>() == place;
  };
  bool same = listed.is_array() && listed.size() == contacts.size();
  for (std::size_t k = 0; same && k < contacts.size(); ++k) {
    const json& pair = listed[k];
    same = pair.is_array() && pair.size() == 2 && is_place(pair[0], contacts[k].body) &&
           is_place(pair[1], contacts[k].other);
  }
  expect(same, "truth.contacts: not those of this step");
}

/// The conditions of Karush, Kuhn and Tucker, which are sufficient for a convex quadratic program: the impulses produce
/// the velocities, they only push, and only where the demand is met without a surplus.
void push(const Claim& claim, const std::vector<Met>& contacts, std::vector<Mover>& bodies, const Rational& e) {
  const std::vector<Rational> impulses = claim.list("impulses");
  expect(impulses.size() == contacts.size(), "certificate.impulses: one for each contact");
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    expect(sgn(impulses[k]) >= 0, "certificate.impulses: not negative");
    const auto& [i, j, normal, parting] = contacts[k];
    bodies[i].velocity = along(bodies[i].velocity, bodies[i].inverse_mass * impulses[k], normal);
    if (j < bodies.size())
      bodies[j].velocity = along(bodies[j].velocity, -bodies[j].inverse_mass * impulses[k], normal);
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& [i, j, normal, before] = contacts[k];
    const Triple relative = j < bodies.size() ? bodies[i].velocity - bodies[j].velocity : bodies[i].velocity;
    const Rational parting = dot(normal, relative), demand = -e * before;
    expect(parting >= demand, numbered("truth.contacts", k) + ": its demand is broken");
    expect(sgn(impulses[k]) == 0 || parting == demand, numbered("truth.contacts", k) + ": pushes beyond its demand");
  }
}

void expect_state(const json& value, const std::string& name, const Triple& position, const Triple& velocity) {
  only(value, name, {"position", "velocity"});
  expect(exact_triple(value["position"], name + ".position") == position, name + ".position: not where it comes to");
  expect(exact_triple(value["velocity"], name + ".velocity") == velocity, name + ".velocity: not what impulses make");
}

void check_simulation_step(const Claim& claim) {
  claim.inputs({"bodies", "walls", "settings"});
  std::vector<Mover> bodies = movers(claim.input["bodies"]);
  const std::vector<Plane> walls = planes(claim.input["walls"]);
  const Settings settings = settings_of(claim.input["settings"]);
  const bool falls_first = settings.motion == "accelerate_then_move";
  claim.answers({"contacts", "bodies"});
  claim.expect_kind("pushes");
  claim.facts({"impulses"});
  if (falls_first) accelerate(bodies, settings);
  std::vector<Triple> ends;
  for (const Mover& body : bodies) ends.push_back(end_of(body, settings));
  if (!falls_first && !settings.before_move) accelerate(bodies, settings);
  const std::vector<Met> contacts = contacts_at(ends, bodies, walls);
  expect_listed(claim, contacts);
  push(claim, contacts, bodies, settings.restitution);
  for (std::size_t i = 0; i < bodies.size() && settings.before_move; ++i) ends[i] = end_of(bodies[i], settings);
  if (!falls_first && settings.before_move) accelerate(bodies, settings);
  const json& states = claim.truth["bodies"];
  expect(states.is_array() && states.size() == bodies.size(), "truth.bodies: one for each body");
  for (std::size_t i = 0; i < bodies.size(); ++i)
    expect_state(states[i], numbered("truth.bodies", i), ends[i], bodies[i].velocity);
}

}  // namespace

Checks checks_of_steps() { return {{"simulation_step", check_simulation_step}}; }

}  // namespace touchstone::certify
