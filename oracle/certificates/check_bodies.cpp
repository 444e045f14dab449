// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_bodies.h"

namespace touchstone::certify {

std::vector<Body> bodies(const json& value, const std::string& what) {
  expect(value.is_array(), what + ": a list");
  std::vector<Body> result;
  for (const json& body : value) {
    const std::string name = what + "[" + std::to_string(result.size()) + "]";
    only(body, name, {"mass", "velocity"});
    const Rational mass = number(body["mass"], name + ".mass");
    result.push_back({mass, point_in_space(body["velocity"], name + ".velocity")});
    expect(sgn(mass) > 0, name + ".mass: mass > 0");
  }
  return result;
}

RigidBody rigid_body(const json& value, const std::string& what) {
  only(value, what, {"mass", "inertia", "position", "velocity", "angular_velocity"});
  const json& rows = value["inertia"];
  const std::string name = what + ".inertia";
  expect(rows.is_array() && rows.size() == 3, name + ": a list of three");
  const Rational mass = number(value["mass"], what + ".mass");
  const Triple x = point_in_space(rows[0], name + "[0]"), y = point_in_space(rows[1], name + "[1]"),
               z = point_in_space(rows[2], name + "[2]");
  const MovingBody motion{point_in_space(value["position"], what + ".position"),
                          point_in_space(value["velocity"], what + ".velocity"),
                          point_in_space(value["angular_velocity"], what + ".angular_velocity")};
  expect(x.y == y.x, name + "[1][0]: symmetric");
  expect(x.z == z.x, name + "[2][0]: symmetric");
  expect(y.z == z.y, name + "[2][1]: symmetric");
  expect(sgn(mass) > 0, what + ".mass: mass > 0");
  expect(sgn(x.x) > 0 && sgn(cross(x, y).z) > 0 && sgn(dot(cross(x, y), z)) > 0, name + ": positive definite");
  return {mass, x, y, z, motion};
}

MovingBody moving_body(const json& value, const std::string& what) {
  only(value, what, {"position", "velocity", "angular_velocity"});
  return {point_in_space(value["position"], what + ".position"), point_in_space(value["velocity"], what + ".velocity"),
          point_in_space(value["angular_velocity"], what + ".angular_velocity")};
}

Triple normal(const json& value, const std::string& what) {
  const Triple n = point_in_space(value, what);
  expect(!(n == Triple{0, 0, 0}), what + ": nonzero normal");
  return n;
}

Rational restitution(const json& value, const std::string& what) {
  const Rational e = number(value, what);
  expect(e >= 0 && e <= 1, what + ": between 0 and 1");
  return e;
}

std::vector<Body> two_bodies(const Claim& claim) {
  const json &masses = claim.input["masses"], &velocities = claim.input["velocities"];
  array_of_two(masses, "masses");
  const Rational m1 = number(masses[0], "masses[0]"), m2 = number(masses[1], "masses[1]");
  expect(sgn(m1) > 0, "masses[0]: mass > 0");
  expect(sgn(m2) > 0, "masses[1]: mass > 0");
  array_of_two(velocities, "velocities");
  const Triple v1 = point_in_space(velocities[0], "velocities[0]");
  return {{m1, v1}, {m2, point_in_space(velocities[1], "velocities[1]")}};
}

}  // namespace touchstone::certify
