// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_solids.h"

namespace touchstone::certify {
namespace {

void check_point_in_convex_polyhedron(const Claim& claim) {
  claim.inputs({"mesh", "point"});
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  const Triple p = point_in_space(claim.input["point"], "point");
  const std::vector<Plane> planes = outward_planes(surface, "mesh");
  claim.answers({"location"});
  if (claim.kind() == "separating_face") {
    claim.facts({"face"});
    const Plane& plane = planes[index(claim.single("face"), planes.size())];
    expect(sgn(plane.at(p)) > 0, "certificate: the face does not separate");
    expect(claim.word("location") == "outside", "truth: location is wrong");
    return;
  }
  claim.expect_kind("barycentric"), claim.facts({"corners", "weights"});
  const std::vector<Rational> corners = claim.list("corners"), weights = claim.list("weights");
  expect(corners.size() == 4 && weights.size() == 4, "certificate: four corners and their weights");
  Rational sum;
  Triple combination{0, 0, 0};
  for (std::size_t k = 0; k < 4; ++k) {
    expect(sgn(weights[k]) >= 0, "certificate: a weight is negative");
    sum += weights[k];
    combination = along(combination, weights[k], surface.vertices[index(corners[k], surface.vertices.size())]);
  }
  expect(sum == 1 && combination == p, "certificate: the weights give another point");
  bool on = false;
  for (const Plane& plane : planes) on = on || sgn(plane.at(p)) == 0;
  expect(claim.word("location") == (on ? "boundary" : "inside"), "truth: location is wrong");
}

void check_point_in_polyhedron(const Claim& claim) {
  claim.inputs({"mesh", "point"});
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  const Triple p = point_in_space(claim.input["point"], "point");
  expect_even(surface, "mesh");
  claim.answers({"location"});
  const std::string location = proved_location(claim, surface, p);
  expect(claim.word("location") == location, "truth: location is wrong");
}

}  // namespace

Checks checks_of_polyhedra() {
  return {{"point_in_convex_polyhedron", check_point_in_convex_polyhedron},
          {"point_in_polyhedron", check_point_in_polyhedron}};
}

}  // namespace touchstone::certify
