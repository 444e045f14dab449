// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/certificates/check_solids.h"
#include "oracle/certificates/check_triangles.h"

namespace touchstone::certify {
namespace {

/// The points from + t way with t >= 0, and t <= 1 if it ends.
struct Line {
  Triple from, displacement;
  bool ends;
};

Line segment_in_space(const json& value, const std::string& what) {
  const Ends3 ends = points<2>(value, what);
  return {ends[0], ends[1] - ends[0], true};
}

Line ray_in_space(const json& value, const std::string& what) {
  only(value, what, {"origin", "direction"});
  const Line line{point_in_space(value["origin"], what + ".origin"),
                  point_in_space(value["direction"], what + ".direction"), false};
  expect(!(line.displacement == Triple{0, 0, 0}), what + ".direction: nonzero direction");
  return line;
}

/// The height over the plane is linear along the line: first + t climb.
void prove_line_plane(const Claim& claim, const Line& line, const Plane& level) {
  const std::string relation = claim.word("relation");
  expect(relation == "none" || relation == "point" || relation == "inside", "truth: relation is wrong");
  if (relation == "point") claim.answers({"relation", "t", "point"});
  else claim.answers({"relation"});
  claim.expect_kind("heights"), claim.facts({"heights"});
  const auto [first, second] = claim.pair("heights");
  expect(first == level.at(line.from) && second == level.at(along(line.from, 1, line.displacement)),
         "certificate: the heights are wrong");
  const Rational climb(second - first);
  if (relation == "inside") {
    expect(sgn(first) == 0 && sgn(second) == 0, "truth: relation is wrong");
  } else if (relation == "none") {
    // It is not 0 at the start, and on a line that ends has the same sign there; on a line that does not end, it grows.
    expect(sgn(first) != 0 && (line.ends ? sgn(first) == sgn(second) : sgn(first) * sgn(climb) >= 0),
           "truth: relation is wrong");
  } else {
    const Rational t = exact_value(claim.truth["t"], "truth.t");
    const bool on_line = sgn(t) >= 0 && (!line.ends || t <= 1);
    expect(sgn(climb) != 0 && on_line && sgn(Rational(first + t * climb)) == 0, "truth: t is wrong");
    expect(exact_triple(claim.truth["point"], "truth.point") == along(line.from, t, line.displacement),
           "truth: point is not at t");
  }
}

void check_segment_plane(const Claim& claim) {
  claim.inputs({"segment", "plane"});
  const Line line = segment_in_space(claim.input["segment"], "segment");
  prove_line_plane(claim, line, plane(claim.input["plane"], "plane"));
}

void check_ray_plane(const Claim& claim) {
  claim.inputs({"ray", "plane"});
  const Line line = ray_in_space(claim.input["ray"], "ray");
  prove_line_plane(claim, line, plane(claim.input["plane"], "plane"));
}

/// Requires that nothing is common: the plane has the triangle behind it, and the ray in front until t = until; from
/// there on each of its points is farther along its direction than every corner.
void expect_apart(const std::vector<Rational>& numbers, const Rational& until, const Line& ray,
                  const Corners& corners) {
  expect(numbers.size() == 4, "certificate: a plane has four numbers");
  const Plane plane{{numbers[0], numbers[1], numbers[2]}, Rational(-numbers[3])};
  const Triple end = along(ray.from, until, ray.displacement);
  expect(sgn(plane.at(ray.from)) > 0 && sgn(plane.at(end)) > 0, "certificate: the plane does not separate");
  for (const Triple& corner : corners) {
    expect(sgn(plane.at(corner)) < 0, "certificate: the plane does not separate");
    expect(sgn(dot(ray.displacement, end - corner)) > 0, "certificate: a corner is farther ahead");
  }
}

/// The first common point of a ray and a triangle.
struct FirstCommon {
  Rational t;
  Triple point;
  bool inside;
};

/// Requires weights of so many points, the first or the first and another one, and a plane that keeps the triangle from
/// what comes before.
FirstCommon proved_first(const Claim& proof, const Line& ray, const Corners& corners, std::size_t points) {
  const std::vector<Rational> t = proof.list("on_ray"), weights = proof.list("weights"), before = proof.list("before");
  expect(t.size() == points && weights.size() == 3 * t.size(), "certificate: one common point, or two");
  const bool one = points == 1;
  expect(sgn(t.front()) >= 0 && (one || t[0] < t[1]), "certificate: the parameters do not rise from 0");
  const Triple first = along(ray.from, t[0], ray.displacement);
  for (std::size_t i = 0; i < t.size(); ++i) {
    expect(weighted(corners, weights, 3 * i) == along(ray.from, t[i], ray.displacement),
           "certificate: the weights give another point");
  }
  // The first point, which is common, is on the plane: if another point is in front, so is the ray from there on.
  if (sgn(t[0]) > 0 || !before.empty()) expect_nothing_before(before, corners, ray.from, first);
  // In a triangle with an area the weights of a point are unique.
  const bool area = !(cross(corners[1] - corners[0], corners[2] - corners[0]) == Triple{0, 0, 0});
  return {t[0], first, area && sgn(weights[0]) > 0 && sgn(weights[1]) > 0 && sgn(weights[2]) > 0};
}

void expect_first(const Claim& claim, const FirstCommon& first) {
  expect(exact_value(claim.truth["t"], "truth.t") == first.t, "truth: t is wrong");
  expect(exact_triple(claim.truth["point"], "truth.point") == first.point, "truth: point is not at t");
}

void check_ray_triangle(const Claim& claim) {
  claim.inputs({"ray", "triangle"});
  const Line ray = ray_in_space(claim.input["ray"], "ray");
  const Corners corners = points<3>(claim.input["triangle"], "triangle");
  const std::string relation = claim.word("relation");
  expect(relation == "none" || relation == "point" || relation == "segment", "truth: relation is wrong");
  const bool one = relation == "point";
  if (relation == "none") {
    claim.answers({"relation"});
    claim.expect_kind("separating_plane"), claim.facts({"plane", "until"});
    return expect_apart(claim.list("plane"), claim.single("until"), ray, corners);
  }
  if (one) claim.answers({"relation", "t", "point", "location"});
  else claim.answers({"relation", "t", "point"});
  claim.expect_kind("common_part"), claim.facts({"on_ray", "weights", "before", "after"});
  const FirstCommon first = proved_first(claim, ray, corners, one ? 1 : 2);
  const std::vector<Rational> after = claim.list("after");
  if (one || !after.empty())
    expect_nothing_before(after, corners, along(first.point, 1, ray.displacement), first.point);
  expect_first(claim, first);
  if (one) expect(claim.word("location") == (first.inside ? "inside" : "boundary"), "truth: location is wrong");
}

/// Each face is proved once, by a plane that the ray does not reach or by what they have in common.
void check_ray_mesh(const Claim& claim) {
  claim.inputs({"ray", "mesh"});
  const Line ray = ray_in_space(claim.input["ray"], "ray");
  const Mesh surface = listed_faces(claim.input["mesh"], "mesh");
  const std::string relation = claim.word("relation");
  expect(relation == "none" || relation == "hit", "truth: relation is wrong");
  if (relation == "hit") claim.answers({"relation", "first", "faces_met"});
  else claim.answers({"relation", "faces_met"});
  claim.expect_kind("faces"), claim.facts({"until", "missed", "met"});
  const Rational until = claim.single("until");
  std::set<std::size_t> proved;
  const auto corners_of = [&](const Rational& value) {
    const std::size_t face = index(value, surface.faces.size());
    expect(proved.insert(face).second, "certificate: a face is proved twice");
    const auto& [a, b, c] = surface.faces[face];
    return Corners{surface.vertices[a], surface.vertices[b], surface.vertices[c]};
  };
  for (const Claim& proof : claim.proofs("missed")) {
    proof.expect_kind("separating_plane"), proof.facts({"plane", "faces"});
    const std::vector<Rational> plane = proof.list("plane");
    for (const Rational& face : proof.list("faces")) expect_apart(plane, until, ray, corners_of(face));
  }
  std::map<std::pair<Rational, std::size_t>, FirstCommon> met;  // by t and by index
  std::set<std::size_t> faces_met;
  for (const Claim& proof : claim.proofs("met")) {
    proof.expect_kind("common_part"), proof.facts({"face", "on_ray", "weights", "before"});
    const FirstCommon first = proved_first(proof, ray, corners_of(proof.single("face")), 1);
    const std::size_t face = surface.face_of[index(proof.single("face"), surface.faces.size())];
    met.insert({{first.t, face}, first}), faces_met.insert(face);
  }
  expect(proved.size() == surface.faces.size(), "certificate: a face is left out");
  expect(relation == (met.empty() ? "none" : "hit"), "truth: relation is wrong");
  const auto is_count = [](const json& given, std::size_t number) {
    return given.is_number_unsigned() && number == given.get<std::uint64_t>();
  };
  expect(is_count(claim.truth["faces_met"], faces_met.size()), "truth: faces_met is wrong");
  if (met.empty()) return;
  const Claim hit{claim.input, claim.truth["first"], claim.certificate};
  hit.answers({"t", "point", "face", "part"});
  const auto& [key, first] = *met.begin();
  const std::size_t face = key.second;
  expect_first(hit, first);
  expect(is_count(hit.truth["face"], face), "truth: face is wrong");
  expect(hit.word("part") == part_of(surface, face, first.point), "truth: part is wrong");
}

}  // namespace

Checks checks_of_rays() {
  return {{"segment_plane", check_segment_plane},
          {"ray_plane", check_ray_plane},
          {"ray_triangle", check_ray_triangle},
          {"ray_mesh", check_ray_mesh}};
}

}  // namespace touchstone::certify
