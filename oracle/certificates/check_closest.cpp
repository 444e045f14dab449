// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

const char* const wrong_kind = "certificate: no such kind for this truth";

/// No point of the box is lower over the plane than x, which is one of them: on each axis on which the plane slopes, x
/// is at the lower end.
bool is_lowest(const Box& box, const Plane& plane, const std::vector<Rational>& x) {
  const Rational slopes[]{plane.normal.x, plane.normal.y, plane.normal.z};
  for (std::size_t k = 0; k < 3; ++k)
    if ((sgn(slopes[k]) > 0 && x[k] != box.min[k]) || (sgn(slopes[k]) < 0 && x[k] != box.max[k])) return false;
  return true;
}

void check_aabb_plane(const Claim& claim) {
  claim.inputs({"aabb", "plane"});
  const Box box = box_in_space(claim.input["aabb"], "aabb");
  const Plane level = plane(claim.input["plane"], "plane");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool disjoint = contact == "disjoint", overlapping = contact == "overlapping", flat = kind == "flat_axis";
  expect(disjoint || overlapping || contact == "touching", "truth: contact is wrong");
  expect(overlapping ? kind == "common_interior_point" : kind == "lowest_point" || (flat && !disjoint), wrong_kind);
  if (flat) claim.facts({"point", "axis"});
  else claim.facts({"point"});
  const Triple point = triple(claim, "point");
  const std::vector<Rational> x{point.x, point.y, point.z};
  const int height = sgn(level.at(point));
  expect(box.holds(x), "certificate: the point is not in the box");
  if (overlapping) {
    for (std::size_t k = 0; k < 3; ++k)
      expect(box.min[k] < x[k] && x[k] < box.max[k], "certificate: the point is not inside the box");
    expect(height < 0, "certificate: the point is not behind the plane");
  } else if (flat) {
    expect(height <= 0, "certificate: the point is in front of the plane");
    const Rational axis = claim.single("axis");
    bool found = false;
    for (std::size_t k = 0; k < 3; ++k)
      found = found || (axis == static_cast<unsigned long>(k) && box.min[k] == box.max[k]);
    expect(found, "certificate: the box is not flat on the axis");
  } else {
    expect(is_lowest(box, level, x), "certificate: a point of the box is lower");
    expect(disjoint ? height > 0 : height == 0, "certificate: the height of the point proves another truth");
  }
}

}  // namespace

Checks checks_of_closest() { return {{"aabb_plane", check_aabb_plane}}; }

}  // namespace touchstone::certify
