// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_space.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

const char* const no_proof = "certificate: the kind does not hold";

/// |c + t v|^2 - r^2 for the position c and velocity v of a relative to b and the sum r of the radii: at most 0 if the
/// balls meet.
Quadratic squared_gap(const Claim& claim) {
  const Ball a = ball(claim.input["a"], "a"), b = ball(claim.input["b"], "b");
  const Triple velocity_a = point_in_space(claim.input["velocity_a"], "velocity_a"),
               velocity_b = point_in_space(claim.input["velocity_b"], "velocity_b");
  const Triple c = a.center - b.center, v = velocity_a - velocity_b;
  const Rational r(a.radius + b.radius);
  return {Rational(dot(c, c) - r * r), Rational(2 * dot(c, v)), dot(v, v)};
}

/// Requires that the truth is the first zero in [0, 1] of f, which is recomputed; 0 if f(0) <= 0.
void prove_first_zero(const Claim& claim, const Quadratic& f) {
  const std::string relation = claim.word("relation"), kind = claim.kind();
  expect(relation == "hit" || relation == "never", "truth: relation is wrong");
  claim.facts({"polynomial"});
  const Triple claimed = triple(claim, "polynomial");
  expect(claimed == Triple{f.constant, f.linear, f.square}, "certificate: the polynomial is wrong");
  if (relation == "never") {
    claim.answers({"relation"});
    expect(f.proved_positive(kind, /*ends=*/true), no_proof);
    return;
  }
  claim.answers({"relation", "t"});
  const Surd t = exact_surd(claim.truth["t"], "truth.t");
  if (kind == "start") {
    expect(sgn(f.constant) <= 0, no_proof);
    expect(sign(t) == 0, "truth: t is wrong");
    return;
  }
  expect(kind == "first_root", wrong_kind);
  expect(sgn(f.constant) > 0, no_proof);
  // f' grows and is at most 0 at t, so f falls until its zero at t: before, it is positive.
  const bool first = sign(t) > 0 && sign(t + Rational(-1)) <= 0 && sign(f.at(t)) == 0 && sign(f.slope_at(t)) <= 0;
  expect(first, "truth: t is wrong");
}

void check_swept_sphere_sphere(const Claim& claim) {
  claim.inputs({"a", "b", "velocity_a", "velocity_b"});
  prove_first_zero(claim, squared_gap(claim));
}

/// E^2 - r^2 N . N for the height E = N . (c + t v) + d of the center: at most 0 if ball and plane meet.
void check_swept_sphere_plane(const Claim& claim) {
  claim.inputs({"sphere", "velocity", "plane"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  const Plane level = plane(claim.input["plane"], "plane");
  const Rational e = level.at(sphere.center), rise = dot(level.normal, velocity), r(sphere.radius);
  prove_first_zero(claim, {Rational(e * e - r * r * dot(level.normal, level.normal)), Rational(2 * e * rise),
                           Rational(rise * rise)});
}

}  // namespace

Checks checks_of_sweeps() {
  return {{"swept_sphere_sphere", check_swept_sphere_sphere}, {"swept_sphere_plane", check_swept_sphere_plane}};
}

}  // namespace touchstone::certify
