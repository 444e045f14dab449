// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "oracle/certificates/check_meshes.h"

namespace touchstone::certify {
namespace {

const char* const wrong_kind = "certificate: no such kind for this truth";

/// A number of the certificate that counts from 0.
std::size_t index(const Rational& value, std::size_t count) {
  const bool there = value.get_den() == 1 && sgn(value) >= 0 && value < static_cast<unsigned long>(count);
  expect(there, "certificate: not an index");
  return value.get_num().get_ui();
}

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
  expect(claim.kind() == "barycentric", wrong_kind), claim.facts({"corners", "weights"});
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

/// Every edge, a pair of vertices in whichever order, is in an even number of faces.
void expect_even(const Mesh& mesh, const std::string& what) {
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++times[std::minmax(face[k], face[(k + 1) % 3])];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = mesh.faces[i][k], to = mesh.faces[i][(k + 1) % 3];
      const std::string field = what + ".faces[" + std::to_string(i) + "]",
                        edge = "from vertex " + std::to_string(from) + " to vertex " + std::to_string(to);
      expect(times[std::minmax(from, to)] % 2 == 0,
             field + ": closed: the edge " + edge + " must be in an even number of faces");
    }
  }
}

void check_point_in_polyhedron(const Claim& claim) {
  claim.inputs({"mesh", "point"});
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  const Triple p = point_in_space(claim.input["point"], "point");
  expect_even(surface, "mesh");
  claim.answers({"location"});
  const auto corner = [&](std::size_t face, std::size_t k) { return surface.vertices[surface.faces[face][k]]; };
  if (claim.kind() == "on_face") {
    claim.facts({"face", "weights"});
    const std::size_t face = index(claim.single("face"), surface.faces.size());
    const std::vector<Rational> weights = claim.list("weights");
    expect(weights.size() == 3, "certificate: three weights");
    Rational sum;
    Triple combination{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      expect(sgn(weights[k]) >= 0, "certificate: a weight is negative");
      sum += weights[k];
      combination = along(combination, weights[k], corner(face, k));
    }
    expect(sum == 1 && combination == p, "certificate: the weights give another point");
    expect(claim.word("location") == "boundary", "truth: location is wrong");
    return;
  }
  expect(claim.kind() == "crossings", wrong_kind), claim.facts({"direction", "faces", "t"});
  const Triple direction = triple(claim, "direction");
  std::vector<Rational> crossed, parameters;
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    const auto t = crossing({corner(i, 0) - p, corner(i, 1) - p, corner(i, 2) - p}, direction);
    if (t) crossed.emplace_back(i), parameters.push_back(*t);
  }
  expect(claim.list("faces") == crossed && claim.list("t") == parameters, "certificate: the ray crosses other faces");
  expect(claim.word("location") == (crossed.size() % 2 == 1 ? "inside" : "outside"), "truth: location is wrong");
}

}  // namespace

Checks checks_of_polyhedra() {
  return {{"point_in_convex_polyhedron", check_point_in_convex_polyhedron},
          {"point_in_polyhedron", check_point_in_polyhedron}};
}

}  // namespace touchstone::certify
