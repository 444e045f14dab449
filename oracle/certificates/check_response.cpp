// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_bodies.h"

namespace touchstone::certify {
namespace {

/// One component is negated, the others stay; so kinetic energy is conserved.
void check_reflect_wall(const Claim& claim) {
  claim.inputs({"velocity", "axis"});
  const Triple before = point_in_space(claim.input["velocity"], "velocity");
  const json& axis = claim.input["axis"];
  expect(axis == "x" || axis == "y" || axis == "z", "axis: x, y or z");
  claim.answers({"velocity"});
  claim.expect_kind("components"), claim.facts({"squared_speeds"});
  const Triple after = exact_triple(claim.truth["velocity"], "truth.velocity");
  const Pair speeds = claim.pair("squared_speeds");
  expect(speeds == Pair{dot(before, before), dot(after, after)}, "certificate: the squared speeds are wrong");
  expect(speeds.x == speeds.y, "truth: kinetic energy is not kept");
  const auto moves_on = [&axis](const Rational& from, const Rational& to, const char* along) {
    return axis == along ? sgn(Rational(from + to)) == 0 : from == to;
  };
  expect(moves_on(before.x, after.x, "x") && moves_on(before.y, after.y, "y") && moves_on(before.z, after.z, "z"),
         "truth: velocity is wrong");
}

/// u is along n, w perpendicular to it, and their sum is v. So v' = w - k u follows from the law.
void check_decomposition(const Claim& claim, const Triple& v, const Triple& n, const Rational& k) {
  const Triple none{0, 0, 0};
  claim.answers({"velocity"});
  claim.expect_kind("decomposition"), claim.facts({"along", "across"});
  const Triple after = exact_triple(claim.truth["velocity"], "truth.velocity"), u = triple(claim, "along"),
               w = triple(claim, "across");
  expect(u + w == v, "certificate: the parts do not make up the velocity");
  expect(cross(u, n) == none, "certificate: along is not along the normal");
  expect(sgn(dot(w, n)) == 0, "certificate: across is not across the normal");
  expect(after == w - k * u, "truth: velocity is wrong");
}

void check_reflect_plane(const Claim& claim) {
  claim.inputs({"velocity", "normal"});
  const Triple v = point_in_space(claim.input["velocity"], "velocity");
  check_decomposition(claim, v, normal(claim.input["normal"], "normal"), 1);
}

void check_damped_reflection(const Claim& claim) {
  claim.inputs({"velocity", "normal", "k"});
  const Triple v = point_in_space(claim.input["velocity"], "velocity"), n = normal(claim.input["normal"], "normal");
  check_decomposition(claim, v, n, number(claim.input["k"], "k"));
}

/// Momentum is conserved, and only one velocity is common to both.
void check_inelastic_collision(const Claim& claim) {
  claim.inputs({"masses", "velocities"});
  const std::vector<Body> before = two_bodies(claim);
  claim.answers({"velocity"});
  claim.expect_kind("momentum"), claim.facts({"momentum"});
  const Triple after = exact_triple(claim.truth["velocity"], "truth.velocity"), p = triple(claim, "momentum");
  const Body &first = before[0], &second = before[1];
  expect(p == first.mass * first.velocity + second.mass * second.velocity, "certificate: the momentum is wrong");
  expect(Rational(first.mass + second.mass) * after == p, "truth: momentum is not kept");
}

/// Both velocities change along the normal, by opposite impulses, so momentum is conserved and the tangential parts
/// stay. Only one impulse multiplies the relative velocity along the normal by -e.
void check_impulse(const Claim& claim, const std::vector<Body>& before, const Triple& n, const Rational& e) {
  claim.answers({"velocities"});
  claim.expect_kind("impulse"), claim.facts({"impulse", "doubled_energies"});
  const json& truth = claim.truth["velocities"];
  expect(truth.is_array() && truth.size() == 2, "truth.velocities: a list of two");
  const Triple v = exact_triple(truth[0], "truth.velocities[0]"), w = exact_triple(truth[1], "truth.velocities[1]");
  const Body &first = before[0], &second = before[1];
  const Rational impulse = claim.single("impulse");
  const Pair energies = claim.pair("doubled_energies");
  expect(first.mass * (v - first.velocity) == impulse * n, "truth: the first body's impulse is another");
  expect(second.mass * (w - second.velocity) == Rational(-impulse) * n, "truth: momentum is not kept");
  expect(dot(v - w, n) == Rational(-e * dot(first.velocity - second.velocity, n)),
         "truth: the relative velocity along the normal is wrong");
  const auto doubled = [&](const Triple& p, const Triple& q) {
    return Rational(first.mass * dot(p, p) + second.mass * dot(q, q));
  };
  expect(energies == Pair{doubled(first.velocity, second.velocity), doubled(v, w)},
         "certificate: the energies are wrong");
  expect(e == 1 ? energies.y == energies.x : energies.y <= energies.x, "truth: energy is gained or lost");
}

void check_elastic_collision(const Claim& claim) {
  claim.inputs({"masses", "velocities", "normal"});
  const std::vector<Body> before = two_bodies(claim);
  check_impulse(claim, before, normal(claim.input["normal"], "normal"), 1);
}

void check_restitution_collision(const Claim& claim) {
  claim.inputs({"masses", "velocities", "normal", "e"});
  const std::vector<Body> before = two_bodies(claim);
  const Triple n = normal(claim.input["normal"], "normal");
  check_impulse(claim, before, n, restitution(claim.input["e"], "e"));
}

void check_momentum(const Claim& claim) {
  claim.inputs({"bodies"});
  Triple sum{0, 0, 0};
  for (const auto& [mass, velocity] : bodies(claim.input["bodies"], "bodies")) sum = sum + mass * velocity;
  claim.answers({"momentum"});
  claim.expect_kind("sum"), claim.facts({});
  expect(exact_triple(claim.truth["momentum"], "truth.momentum") == sum, "truth: momentum is wrong");
}

/// The energy is that of the total mass at the centre's velocity plus that of the bodies relative to it (Koenig); and
/// it is their sum.
void check_kinetic_energy(const Claim& claim) {
  claim.inputs({"bodies"});
  const std::vector<Body> all = bodies(claim.input["bodies"], "bodies");
  claim.answers({"energy"});
  claim.expect_kind("centre"), claim.facts({"mass", "velocity", "doubled_energies"});
  const Rational energy = exact_value(claim.truth["energy"], "truth.energy"), mass = claim.single("mass");
  const Triple centre = triple(claim, "velocity");
  const Pair parts = claim.pair("doubled_energies");
  Rational weight, doubled, seen;
  Triple momentum{0, 0, 0};
  for (const auto& [m, v] : all) {
    weight += m, momentum = momentum + m * v;
    doubled += m * dot(v, v), seen += m * dot(v - centre, v - centre);
  }
  expect(mass == weight, "certificate: the mass is wrong");
  expect(mass * centre == momentum && (sgn(mass) > 0 || centre == Triple{0, 0, 0}),
         "certificate: the velocity of the centre is wrong");
  expect(parts == Pair{Rational(mass * dot(centre, centre)), seen}, "certificate: the energies are wrong");
  expect(Rational(2 * energy) == doubled && Rational(parts.x + parts.y) == doubled, "truth: energy is wrong");
}

/// The spring pulls from the point to its foot on the plane, and the damper opposes the velocity along the normal.
void check_penalty_force(const Claim& claim) {
  claim.inputs({"point", "velocity", "plane", "stiffness", "damping"});
  const Triple none{0, 0, 0}, p = point_in_space(claim.input["point"], "point"),
                              v = point_in_space(claim.input["velocity"], "velocity");
  const Plane behind = plane(claim.input["plane"], "plane");
  const Rational k = number(claim.input["stiffness"], "stiffness"), c = number(claim.input["damping"], "damping");
  claim.answers({"force"});
  const Triple force = exact_triple(claim.truth["force"], "truth.force");
  if (sgn(behind.at(p)) >= 0) {
    claim.expect_kind("no_contact"), claim.facts({});
    expect(force == none, "truth: force is wrong");
    return;
  }
  claim.expect_kind("foot"), claim.facts({"foot", "along"});
  const Triple foot = triple(claim, "foot"), u = triple(claim, "along");
  expect(sgn(behind.at(foot)) == 0, "certificate: the foot is not on the plane");
  expect(cross(foot - p, behind.normal) == none, "certificate: the foot is another point's");
  expect(cross(u, behind.normal) == none, "certificate: along is not along the normal");
  expect(sgn(dot(v - u, behind.normal)) == 0, "certificate: along is not all of it");
  expect(force == k * (foot - p) - c * u, "truth: force is wrong");
}

/// The sign of the relative velocity along the normal.
void check_contact_state(const Claim& claim) {
  claim.inputs({"a", "b", "point", "normal"});
  const MovingBody a = moving_body(claim.input["a"], "a"), b = moving_body(claim.input["b"], "b");
  const Triple p = point_in_space(claim.input["point"], "point"), n = normal(claim.input["normal"], "normal");
  claim.answers({"state"});
  claim.expect_kind("point_velocities"), claim.facts({"of_a", "of_b"});
  const Triple of_a = triple(claim, "of_a"), of_b = triple(claim, "of_b");
  expect(of_a == a.velocity_at(p), "certificate: of_a is wrong");
  expect(of_b == b.velocity_at(p), "certificate: of_b is wrong");
  const int sign = sgn(dot(of_a - of_b, n));
  expect(claim.word("state") == (sign > 0   ? "separating"
                                 : sign < 0 ? "colliding"
                                            : "resting"),
         "truth: state is wrong");
}

/// Only one impulse at the contact along the normal multiplies the relative velocity along it by -e.
void check_rigid_body_collision(const Claim& claim) {
  claim.inputs({"a", "b", "point", "normal", "e"});
  const RigidBody a = rigid_body(claim.input["a"], "a"), b = rigid_body(claim.input["b"], "b");
  const Triple p = point_in_space(claim.input["point"], "point"), n = normal(claim.input["normal"], "normal");
  const Rational e = restitution(claim.input["e"], "e");
  claim.answers({"a", "b"});
  claim.expect_kind("impulse_at"), claim.facts({"impulse", "doubled_energies"});
  const Rational impulse = claim.single("impulse");
  const Pair energies = claim.pair("doubled_energies");
  Rational before, after;
  /// The velocity at the contact afterwards.
  const auto checked = [&](const RigidBody& body, const std::string& name, const Triple& push) {
    const json& truth = claim.truth[name];
    only(truth, "truth." + name, {"velocity", "angular_velocity"});
    const Triple v = exact_triple(truth["velocity"], "truth." + name + ".velocity"),
                 w = exact_triple(truth["angular_velocity"], "truth." + name + ".angular_velocity");
    const MovingBody& motion = body.motion;
    expect(body.mass * (v - motion.velocity) == push, "truth: momentum of " + name + " is wrong");
    expect(body.angular_momentum(w - motion.angular_velocity) == cross(p - motion.position, push),
           "truth: angular momentum of " + name + " is wrong");
    before += body.doubled_energy(motion.velocity, motion.angular_velocity), after += body.doubled_energy(v, w);
    return MovingBody{motion.position, v, w}.velocity_at(p);
  };
  const Triple of_a = checked(a, "a", impulse * n), of_b = checked(b, "b", Rational(-impulse) * n);
  expect(dot(of_a - of_b, n) == Rational(-e * dot(a.motion.velocity_at(p) - b.motion.velocity_at(p), n)),
         "truth: the relative velocity along the normal is wrong");
  expect(energies == Pair{before, after}, "certificate: the energies are wrong");
  expect(e == 1 ? after == before : after <= before, "truth: energy is gained or lost");
}

}  // namespace

Checks checks_of_response() {
  return {{"reflect_wall", check_reflect_wall},
          {"reflect_plane", check_reflect_plane},
          {"damped_reflection", check_damped_reflection},
          {"inelastic_collision", check_inelastic_collision},
          {"elastic_collision", check_elastic_collision},
          {"restitution_collision", check_restitution_collision},
          {"penalty_force", check_penalty_force},
          {"contact_state", check_contact_state},
          {"rigid_body_collision", check_rigid_body_collision},
          {"momentum", check_momentum},
          {"kinetic_energy", check_kinetic_energy}};
}

}  // namespace touchstone::certify
