// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_bodies.h"

namespace touchstone::certify {
namespace {

void expect_kind(const Claim& claim, const char* kind) {
  expect(claim.kind() == kind, "certificate: no such kind for this truth");
}

/// One component is negated, the others stay; so kinetic energy is kept.
void check_reflect_wall(const Claim& claim) {
  claim.inputs({"velocity", "axis"});
  const Triple before = point_in_space(claim.input["velocity"], "velocity");
  const json& axis = claim.input["axis"];
  expect(axis == "x" || axis == "y" || axis == "z", "axis: x, y or z");
  claim.answers({"velocity"});
  expect_kind(claim, "components"), claim.facts({"squared_speeds"});
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

/// u is along n, w across it, and both make up v. So v' = w - k u is what the law says.
void check_decomposition(const Claim& claim, const Triple& v, const Triple& n, const Rational& k) {
  const Triple none{0, 0, 0};
  claim.answers({"velocity"});
  expect_kind(claim, "decomposition"), claim.facts({"along", "across"});
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

}  // namespace

Checks checks_of_response() {
  return {{"reflect_wall", check_reflect_wall},
          {"reflect_plane", check_reflect_plane},
          {"damped_reflection", check_damped_reflection}};
}

}  // namespace touchstone::certify
