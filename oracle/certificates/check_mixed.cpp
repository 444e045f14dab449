// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

/// No point of the half-space behind the plane is nearer to c than x, which is one of them: the way from x to c leads
/// along the normal (Cauchy's inequality is an equality), and is 0 unless x is on the plane.
bool is_nearest(const Plane& plane, const Triple& c, const Triple& x) {
  const Triple way = c - x;
  const Rational height = plane.at(x), along = dot(plane.normal, way);
  return sgn(height) <= 0 && sgn(along) >= 0 && sgn(Rational(along * height)) == 0 &&
         along * along == dot(way, way) * dot(plane.normal, plane.normal);
}

void check_sphere_plane(const Claim& claim) {
  claim.inputs({"sphere", "plane"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Plane level = plane(claim.input["plane"], "plane");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool disjoint = contact == "disjoint", overlapping = contact == "overlapping";
  expect(disjoint || overlapping || contact == "touching", "truth: contact is wrong");
  expect(kind == (disjoint      ? "nearest_point"
                  : overlapping ? "common_interior_point"
                                : "tangent"),
         "certificate: no such kind for this truth");
  claim.facts({"point"});
  const Triple point = triple(claim, "point"), way = sphere.center - point;
  const int in_ball = sgn(Rational(dot(way, way) - sphere.radius * sphere.radius));
  if (overlapping) {
    expect(sgn(level.at(point)) < 0 && in_ball < 0, "certificate: the point is not inside both");
    return;
  }
  expect(is_nearest(level, sphere.center, point), "certificate: a point of the half-space is nearer");
  if (disjoint) expect(in_ball > 0, "certificate: the point is in the ball");
  else expect(in_ball == 0, "certificate: the point is not on the boundary of the ball");
}

}  // namespace

Checks checks_of_mixed() { return {{"sphere_plane", check_sphere_plane}}; }

}  // namespace touchstone::certify
