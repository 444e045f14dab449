// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "oracle/certificates/check_solids.h"
#include "oracle/certificates/check_surd.h"

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

Rational squared_length(const Triple& v) { return dot(v, v); }
bool before(const Triple& p, const Triple& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

/// The squared distance of a point from the box around a triangle.
Rational square_to_box(const std::array<Triple, 3>& t, const Triple& p) {
  Rational sum;
  for (Rational Triple::*axis : {&Triple::x, &Triple::y, &Triple::z}) {
    const auto [low, high] = std::minmax({t[0].*axis, t[1].*axis, t[2].*axis});
    sum += square(std::max({Rational(0), Rational(low - p.*axis), Rational(p.*axis - high)}));
  }
  return sum;
}

/// The point of a triangle that is nearest to p: the foot of the perpendicular if it is on the inner side of each edge,
/// else the nearest of the feet on edges, moved between their ends.
Triple nearest_in(const std::array<Triple, 3>& t, const Triple& p) {
  const Triple normal = cross(t[1] - t[0], t[2] - t[0]);
  bool over = sgn(squared_length(normal)) > 0;
  Triple nearest = t[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple &from = t[k], edge = t[(k + 1) % 3] - from;
    const Rational length = squared_length(edge), foot = dot(p - from, edge);
    const Triple x = sgn(foot) <= 0 ? from : along(from, foot < length ? Rational(foot / length) : Rational(1), edge);
    if (squared_length(x - p) < squared_length(nearest - p)) nearest = x;
    over = over && sgn(dot(cross(normal, edge), p - from)) >= 0;
  }
  return over ? along(p, Rational(dot(t[0] - p, normal) / squared_length(normal)), normal) : nearest;
}

void check_point_mesh_distance(const Claim& claim) {
  claim.inputs({"point", "mesh"});
  const Triple p = point_in_space(claim.input["point"], "point");
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  expect_even(surface, "mesh");
  claim.answers({"location", "nearest", "squared_distance", "distance", "signed_distance"});
  claim.facts({"face", "weights", "location"});
  const std::vector<Claim> proofs = claim.proofs("location");
  expect(proofs.size() == 1, "certificate.location: a list of one");
  const std::string location = proved_location(proofs[0], surface, p);
  expect(claim.word("location") == location, "truth: location is wrong");
  const auto corners = [&surface](std::size_t i) {
    const auto& [a, b, c] = surface.faces[i];
    return std::array{surface.vertices[a], surface.vertices[b], surface.vertices[c]};
  };
  const std::size_t face = index(claim.single("face"), surface.faces.size());
  const Triple x = from_weights(claim, corners(face));
  const Rational least = squared_length(x - p);
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    if (square_to_box(corners(i), p) > least) continue;
    const Triple y = nearest_in(corners(i), p);
    const Rational here = squared_length(y - p);
    expect(here >= least, "certificate: a face is nearer");
    expect(here > least || (x == y ? face <= i : before(x, y)), "certificate: another place comes first");
  }
  expect_distance(claim, least);
  const Surd with_sign = exact_surd(claim.truth["signed_distance"], "truth.signed_distance");
  const int side = location == "inside" ? -1 : location == "outside" ? 1 : 0;
  expect(sign(with_sign) == side && sign(certify::square(with_sign) + Rational(-least)) == 0,
         "truth: signed_distance is wrong");
  const std::size_t named = surface.face_of[face];
  const Claim nearest{claim.input, claim.truth["nearest"], claim.certificate};
  nearest.answers({"point", "face", "part"});
  expect(exact_triple(nearest.truth["point"], "truth.point") == x, "truth: point is wrong");
  const json& answered = nearest.truth["face"];
  expect(answered.is_number_unsigned() && answered.get<std::uint64_t>() == named, "truth: face is wrong");
  expect(nearest.word("part") == part_of(surface, named, x), "truth: part is wrong");
}

}  // namespace

Checks checks_of_polyhedra() {
  return {{"point_in_convex_polyhedron", check_point_in_convex_polyhedron},
          {"point_in_polyhedron", check_point_in_polyhedron},
          {"point_mesh_distance", check_point_mesh_distance}};
}

}  // namespace touchstone::certify
