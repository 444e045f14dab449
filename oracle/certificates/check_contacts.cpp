// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "oracle/certificates/check_bodies.h"

namespace touchstone::certify {
namespace {

struct PointBody {
  Rational inverse_mass;
  Triple velocity;
};
struct Contact {
  std::size_t a, b;
  Triple normal;
  /// The required minimum of n . (va - vb) afterwards.
  Rational demand;
};

std::vector<PointBody> point_bodies(const json& value) {
  expect(value.is_array(), "bodies: a list");
  std::vector<PointBody> found;
  for (const json& body : value) {
    const std::string name = numbered("bodies", found.size());
    only(body, name, {"inverse_mass", "velocity"});
    const Rational w = number(body["inverse_mass"], name + ".inverse_mass");
    found.push_back({w, point_in_space(body["velocity"], name + ".velocity")});
    expect(sgn(w) >= 0, name + ".inverse_mass: inverse mass >= 0");
  }
  return found;
}

std::size_t place(const json& value, const std::string& what, std::size_t bodies) {
  expect(value.is_number_unsigned() && value.get<std::uint64_t>() < bodies, what + ": index of a body");
  return value.get<std::size_t>();
}

std::vector<Contact> contacts_of(const json& value, const std::vector<PointBody>& bodies) {
  expect(value.is_array(), "contacts: a list");
  std::vector<Contact> found;
  for (const json& contact : value) {
    const std::string name = numbered("contacts", found.size());
    only(contact, name, {"a", "b", "normal"});
    const std::size_t a = place(contact["a"], name + ".a", bodies.size()),
                      b = place(contact["b"], name + ".b", bodies.size());
    expect(a != b, name + ".b: another body than a");
    found.push_back({a, b, normal(contact["normal"], name + ".normal"), 0});
  }
  return found;
}

void set_demands(std::vector<Contact>& contacts, const std::vector<PointBody>& bodies, const Rational& e) {
  for (Contact& c : contacts) {
    const Rational parting = dot(c.normal, bodies[c.a].velocity - bodies[c.b].velocity);
    if (sgn(parting) < 0) c.demand = -e * parting;
  }
}

/// A number for each contact, none negative.
std::vector<Rational> pushes(const Claim& claim, const char* name, const std::vector<Contact>& contacts) {
  const std::vector<Rational> found = claim.list(name);
  expect(found.size() == contacts.size(), std::string("certificate.") + name + ": one for each contact");
  for (const Rational& push : found) expect(sgn(push) >= 0, std::string("certificate.") + name + ": not negative");
  return found;
}

/// The sums for each body, pushed along normals.
std::vector<Triple> sums(const std::vector<Contact>& contacts, const std::vector<Rational>& pushes,
                         std::size_t bodies) {
  std::vector<Triple> result(bodies, Triple{0, 0, 0});
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    result[c.a] = result[c.a] + pushes[i] * c.normal;
    result[c.b] = result[c.b] - pushes[i] * c.normal;
  }
  return result;
}

/// The conditions of Karush, Kuhn and Tucker, which are sufficient for a convex quadratic program.
void check_velocities(const Claim& claim, const std::vector<PointBody>& bodies, const std::vector<Contact>& contacts) {
  claim.answers({"relation", "velocities"});
  claim.expect_kind("pushes");
  claim.facts({"impulses"});
  const json& truth = claim.truth["velocities"];
  expect(truth.is_array() && truth.size() == bodies.size(), "truth.velocities: one for each body");
  std::vector<Triple> after;
  for (const json& v : truth) after.push_back(exact_triple(v, numbered("truth.velocities", after.size())));
  const std::vector<Rational> impulses = pushes(claim, "impulses", contacts);
  const std::vector<Triple> pushed = sums(contacts, impulses, bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    expect(after[i] == bodies[i].velocity + bodies[i].inverse_mass * pushed[i],
           numbered("truth.velocities", i) + ": not what the impulses make");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    const Rational parting = dot(c.normal, after[c.a] - after[c.b]);
    expect(parting >= c.demand, numbered("contacts", i) + ": its demand is broken");
    expect(sgn(impulses[i]) == 0 || parting == c.demand, numbered("contacts", i) + ": pushes beyond its demand");
  }
}

/// The weighted sum of all demands: the share of movable bodies cancels, and that of the others is less than demanded.
void check_contradiction(const Claim& claim, const std::vector<PointBody>& bodies,
                         const std::vector<Contact>& contacts) {
  claim.answers({"relation"});
  claim.expect_kind("contradiction");
  claim.facts({"weights"});
  const std::vector<Rational> weights = pushes(claim, "weights", contacts);
  const std::vector<Triple> pushed = sums(contacts, weights, bodies.size());
  Rational left;
  for (std::size_t i = 0; i < contacts.size(); ++i) left += weights[i] * contacts[i].demand;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (sgn(bodies[i].inverse_mass) == 0) left -= dot(pushed[i], bodies[i].velocity);
    else expect(pushed[i] == Triple{0, 0, 0}, numbered("bodies", i) + ": the weights do not cancel");
  }
  expect(sgn(left) > 0, "certificate: the demands do not contradict each other");
}

void check_simultaneous_collisions(const Claim& claim) {
  claim.inputs({"bodies", "contacts", "e"});
  const std::vector<PointBody> bodies = point_bodies(claim.input["bodies"]);
  std::vector<Contact> contacts = contacts_of(claim.input["contacts"], bodies);
  set_demands(contacts, bodies, restitution(claim.input["e"], "e"));
  const std::string relation = claim.word("relation");
  expect(relation == "possible" || relation == "impossible", "truth: relation is wrong");
  if (relation == "possible") check_velocities(claim, bodies, contacts);
  else check_contradiction(claim, bodies, contacts);
}

}  // namespace

Checks checks_of_contacts() { return {{"simultaneous_collisions", check_simultaneous_collisions}}; }

}  // namespace touchstone::certify
