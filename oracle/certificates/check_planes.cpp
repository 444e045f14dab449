// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

const char* const wrong_kind = "certificate: no such kind for this truth";

void expect_kind(const Claim& claim, const char* kind) { expect(claim.kind() == kind, wrong_kind); }

void check_point_ground_plane(const Claim& claim) {
  claim.inputs({"point"}), claim.answers({"side"});
  const Triple p = point_in_space(claim.input["point"], "point");
  expect_kind(claim, "height"), claim.facts({"height"});
  const Rational height = claim.single("height");
  expect(height == p.y, "certificate: the height is wrong");
  expect(claim.word("side") == (sgn(height) < 0 ? "below" : sgn(height) > 0 ? "above" : "on"), "truth: side is wrong");
}

}  // namespace

Checks checks_of_planes() {
  return {{"point_ground_plane", check_point_ground_plane}};
}

}  // namespace touchstone::certify
