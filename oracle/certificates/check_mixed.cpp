// SPDX-License-Identifier: Apache-2.0
#include <string>

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

void check_sphere_plane(const Claim& claim) {
  claim.inputs({"sphere", "plane"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Plane level = plane(claim.input["plane"], "plane");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool disjoint = contact == "disjoint", overlapping = contact == "overlapping";
  expect(disjoint || overlapping || contact == "touching", "truth: contact is wrong");
  expect(kind == (disjoint ? "nearest_point" : overlapping ? "common_interior_point" : "tangent"), wrong_kind);
  claim.facts({"point"});
  const Triple point = triple(claim, "point"), displacement = sphere.center - point;
  const int in_ball = sgn(Rational(dot(displacement, displacement) - sphere.radius * sphere.radius));
  if (overlapping) {
    expect(sgn(level.at(point)) < 0 && in_ball < 0, "certificate: the point is not inside both");
    return;
  }
  expect(is_nearest(level, sphere.center, point), "certificate: a point of the half-space is nearer");
  if (disjoint) expect(in_ball > 0, "certificate: the point is in the ball");
  else expect(in_ball == 0, "certificate: the point is not on the boundary of the ball");
}

/// The height of a box's lowest point over a plane: at the lower end of every axis on which the plane slopes.
Rational lowest(const Box& box, const Plane& plane) {
  const auto end = [](const Rational& slope, const Rational& min, const Rational& max) {
    return sgn(slope) > 0 ? min : max;
  };
  const Triple& n = plane.normal;
  return plane.at(
      {end(n.x, box.min[0], box.max[0]), end(n.y, box.min[1], box.max[1]), end(n.z, box.min[2], box.max[2])});
}

/// Requires that no part of the triangle is above the plane, and no part of the box below it; if they are disjoint,
/// none is on it either.
void expect_between(const Claim& claim, const Corners& corners, const Box& box, bool disjoint) {
  const Plane plane{triple(claim, "normal"), Rational(-claim.single("offset"))};
  expect(!(plane.normal == Triple{0, 0, 0}), "certificate: the normal is zero");
  const char* const reason = "certificate: the plane does not separate";
  for (const Triple& corner : corners) expect(sgn(plane.at(corner)) < (disjoint ? 0 : 1), reason);
  expect(sgn(lowest(box, plane)) > (disjoint ? 0 : -1), reason);
}

void check_triangle_aabb(const Claim& claim) {
  claim.inputs({"triangle", "aabb"});
  const Corners corners = points<3>(claim.input["triangle"], "triangle");
  const Box box = box_in_space(claim.input["aabb"], "aabb");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool disjoint = contact == "disjoint", overlapping = contact == "overlapping", flat = kind == "flat_axis";
  expect(disjoint || overlapping || contact == "touching", "truth: contact is wrong");
  expect(disjoint      ? kind == "separating_plane"
         : overlapping ? kind == "common_interior_point"
                       : flat || kind == "supporting_plane",
         wrong_kind);
  if (disjoint) {
    claim.facts({"normal", "offset"}), expect_between(claim, corners, box, true);
    return;
  }
  if (overlapping) claim.facts({"weights"});
  else if (flat) claim.facts({"weights", "axis"});
  else claim.facts({"normal", "offset", "weights"});
  const std::vector<Rational> weights = claim.list("weights");
  expect(weights.size() == 3, "certificate: as many weights as points");
  const Triple point = weighted(corners, weights, 0);
  const std::vector<Rational> x{point.x, point.y, point.z};
  expect(box.holds(x), "certificate: the point is not in the box");
  if (overlapping) {
    expect_inside(box, x);
  } else if (flat) {
    expect_flat_axis(claim, box);
  } else {
    expect_between(claim, corners, box, false);
  }
}

}  // namespace

Checks checks_of_mixed() { return {{"sphere_plane", check_sphere_plane}, {"triangle_aabb", check_triangle_aabb}}; }

}  // namespace touchstone::certify
