// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_space.h"

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

}  // namespace

Checks checks_of_response() { return {{"reflect_wall", check_reflect_wall}}; }

}  // namespace touchstone::certify
