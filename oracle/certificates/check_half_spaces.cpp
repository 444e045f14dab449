// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "oracle/certificates/check_obbs.h"
#include "oracle/certificates/check_triangles.h"

namespace touchstone::certify {
namespace {

/// True if no point of the half-space behind the plane is nearer to c than x, which is one of them: the displacement
/// from x to c is along the normal (Cauchy's inequality is an equality), and is 0 unless x is on the plane.
bool is_nearest(const Plane& plane, const Triple& c, const Triple& x) {
  const Triple displacement = c - x;
  const Rational height = plane.at(x), along = dot(plane.normal, displacement);
  return sgn(height) <= 0 && sgn(along) >= 0 && sgn(Rational(along * height)) == 0 &&
         along * along == dot(displacement, displacement) * dot(plane.normal, plane.normal);
}

/// Checks the contact of a ball and the half-space behind a plane, by the point of the certificate.
void expect_ball_over_plane(const Claim& claim, const Ball& ball, const Plane& level) {
  const Triple point = triple(claim, "point"), displacement = ball.center - point;
  const int in_ball = sgn(Rational(dot(displacement, displacement) - ball.radius * ball.radius));
  const std::string kind = claim.kind();
  if (kind == "common_interior_point") {
    expect(sgn(level.at(point)) < 0 && in_ball < 0, "certificate: the point is not inside both");
    return;
  }
  expect(is_nearest(level, ball.center, point), "certificate: a point of the half-space is nearer");
  if (kind == "nearest_point") expect(in_ball > 0, "certificate: the point is in the ball");
  else expect(in_ball == 0, "certificate: the point is not on the boundary of the ball");
}

/// Requires a contact, and the kind of certificate that proves it.
void expect_contact_and_kind(const Claim& claim, const std::map<std::string, std::string>& kinds) {
  claim.answers({"contact"});
  const auto found = kinds.find(claim.word("contact"));
  expect(found != kinds.end(), "truth: contact is wrong");
  claim.expect_kind(found->second.c_str());
}

const std::map<std::string, std::string> kinds_of_balls{
    {"disjoint", "nearest_point"}, {"touching", "tangent"}, {"overlapping", "common_interior_point"}};

void check_sphere_plane(const Claim& claim) {
  claim.inputs({"sphere", "plane"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Plane level = plane(claim.input["plane"], "plane");
  expect_contact_and_kind(claim, kinds_of_balls);
  claim.facts({"point"});
  expect_ball_over_plane(claim, sphere, level);
}

/// No point of the capsule is lower than that of the ball around the lowest point of its segment.
void check_capsule_plane(const Claim& claim) {
  claim.inputs({"capsule", "plane"});
  const auto [ends, radius] = capsule_in_space(claim.input["capsule"], "capsule");
  const Plane level = plane(claim.input["plane"], "plane");
  expect_contact_and_kind(claim, kinds_of_balls);
  claim.facts({"weights", "point"});
  const std::vector<Rational> weights = claim.list("weights");
  expect(weights.size() == 2, "certificate: as many weights as points");
  for (const Rational& weight : weights) expect(sgn(weight) >= 0, "certificate: a weight is negative");
  expect(weights[0] + weights[1] == 1, "certificate: the weights do not add up to 1");
  const Triple lowest = along(ends[0], weights[1], ends[1] - ends[0]);
  for (const Triple& end : ends)
    expect(level.at(end) >= level.at(lowest), "certificate: a point of the segment is lower");
  expect_ball_over_plane(claim, {lowest, radius}, level);
}

void check_obb_plane(const Claim& claim) {
  claim.inputs({"obb", "plane"});
  const Obb box = obb(claim.input["obb"], "obb");
  const Plane level = plane(claim.input["plane"], "plane");
  expect_contact_and_kind(
      claim, {{"disjoint", "lowest_point"}, {"touching", "lowest_point"}, {"overlapping", "common_interior_point"}});
  claim.facts({"coefficients"});
  const std::vector<Rational> coefficients = claim.list("coefficients");
  const Rational growth = greatest(coefficients, "coefficients"), height = level.at(box.at(coefficients));
  if (claim.kind() == "common_interior_point") {
    expect(growth < 1, "certificate: the point is not inside the box");
    expect(sgn(height) < 0, "certificate: the point is not behind the plane");
    return;
  }
  expect(growth <= 1, "certificate: the point is not in the box");
  expect(height + box.reach(level.normal) == level.at(box.center), "certificate: a point of the box is lower");
  expect(claim.word("contact") == "disjoint" ? sgn(height) > 0 : sgn(height) == 0,
         "certificate: the height of the point proves another truth");
}

}  // namespace

Checks checks_of_half_spaces() {
  return {{"sphere_plane", check_sphere_plane}, {"capsule_plane", check_capsule_plane}, {"obb_plane", check_obb_plane}};
}

}  // namespace touchstone::certify
