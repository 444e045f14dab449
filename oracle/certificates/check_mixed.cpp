// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_triangles.h"

namespace touchstone::certify {
namespace {

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

Checks checks_of_mixed() { return {{"triangle_aabb", check_triangle_aabb}}; }

}  // namespace touchstone::certify
