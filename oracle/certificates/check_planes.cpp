// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_rounding.h"
#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

const char* const wrong_kind = "certificate: no such kind for this truth";

void expect_kind(const Claim& claim, const char* kind) { expect(claim.kind() == kind, wrong_kind); }

Rational square(const Rational& x) { return Rational(x * x); }

/// The number called `name` is height / sqrt(squared_length), of which the root is rational.
void expect_root(const std::string& name, const Rational& claimed, const Rational& height, const Rational& squared_length) {
  expect(sgn(claimed) == sgn(height) && square(claimed) * squared_length == square(height), "truth: " + name + " is wrong");
}

/// It lies between low and high, and what they allow is rounded as what is claimed.
void expect_root_enclosed(const std::string& name, const Rational& claimed, const Pair& ends, const Rational& height,
                          const Rational& squared_length) {
  const auto& [low, high] = ends;
  const bool alike = sgn(height) != 0 && sgn(low) == sgn(height) && sgn(high) == sgn(height);
  const Rational &inner = sgn(height) < 0 ? high : low, &outer = sgn(height) < 0 ? low : high;
  expect(alike && low <= high && square(inner) * squared_length <= square(height) &&
             square(height) <= square(outer) * squared_length,
         "certificate: the bounds of " + name + " are wrong");
  expect_rounds_alike(name, claimed, low, high);
}

void check_point_ground_plane(const Claim& claim) {
  claim.inputs({"point"}), claim.answers({"side"});
  const Triple p = point_in_space(claim.input["point"], "point");
  expect_kind(claim, "height"), claim.facts({"height"});
  const Rational height = claim.single("height");
  expect(height == p.y, "certificate: the height is wrong");
  expect(claim.word("side") == (sgn(height) < 0 ? "below" : sgn(height) > 0 ? "above" : "on"), "truth: side is wrong");
}

void check_point_plane(const Claim& claim) {
  claim.inputs({"plane", "point"}), claim.answers({"side", "signed_distance"});
  const Plane surface = plane(claim.input["plane"], "plane");
  const Triple p = point_in_space(claim.input["point"], "point");
  const bool enclosed = claim.kind() == "enclosure";
  const Rational height = surface.at(p), length = dot(surface.normal, surface.normal);
  expect(claim.word("side") == (sgn(height) < 0 ? "back" : sgn(height) > 0 ? "front" : "on"), "truth: side is wrong");
  const Rational distance = exact_value(claim.truth["signed_distance"], "truth.signed_distance");
  if (enclosed) {
    claim.facts({"distance"});
    expect_root_enclosed("signed_distance", distance, claim.pair("distance"), height, length);
  } else {
    expect_kind(claim, "root"), claim.facts({});
    expect_root("signed_distance", distance, height, length);
  }
}

}  // namespace

Checks checks_of_planes() {
  return {{"point_ground_plane", check_point_ground_plane}, {"point_plane", check_point_plane}};
}

}  // namespace touchstone::certify
