// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_triangles.h"

#include <string>

namespace touchstone::certify {

Capsule capsule_in_space(const json& value, const std::string& what) {
  only(value, what, {"segment", "radius"});
  const Ends3 ends = points<2>(value["segment"], what + ".segment");
  const Rational radius = number(value["radius"], what + ".radius");
  expect(sgn(radius) >= 0, what + ".radius: radius >= 0");
  return {ends, radius};
}

Triple weighted(const std::vector<Triple>& points, const std::vector<Rational>& weights, std::size_t from) {
  Triple sum{0, 0, 0};
  Rational total;
  for (std::size_t k = 0; k < points.size(); ++k) {
    expect(sgn(weights[from + k]) >= 0, "certificate: a weight is negative");
    total += weights[from + k];
    sum = along(sum, weights[from + k], points[k]);
  }
  expect(total == 1, "certificate: the weights do not add up to 1");
  return sum;
}

void expect_nothing_before(const std::vector<Rational>& numbers, const Corners& corners, const Triple& end,
                           const Triple& x) {
  const char* const reason = "certificate: the plane does not keep the triangle apart";
  expect(numbers.size() == 4, reason);
  const Plane plane{{numbers[0], numbers[1], numbers[2]}, Rational(-numbers[3])};
  for (const Triple& corner : corners) expect(sgn(plane.at(corner)) <= 0, reason);
  expect(sgn(plane.at(end)) > 0 && sgn(plane.at(x)) >= 0, reason);
}

namespace {

void check_segment_triangle(const Claim& claim) {
  claim.inputs({"segment", "triangle"});
  const Ends3 s = points<2>(claim.input["segment"], "segment");
  const Corners corners = points<3>(claim.input["triangle"], "triangle");
  const std::string relation = claim.word("relation");
  if (relation == "none") {
    claim.answers({"relation"});
    claim.expect_kind("separating_plane");
    claim.facts({"normal", "offset"});
    const Plane plane{triple(claim, "normal"), Rational(-claim.single("offset"))};
    const char* const reason = "certificate: the plane does not separate";
    for (const Triple& p : s) expect(sgn(plane.at(p)) > 0, reason);
    for (const Triple& p : corners) expect(sgn(plane.at(p)) < 0, reason);
    return;
  }
  expect(relation == "point" || relation == "segment", "truth: relation is wrong");
  if (relation == "point") claim.answers({"relation", "t", "point"});
  else claim.answers({"relation", "overlap"});
  claim.expect_kind("common_part");
  claim.facts({"on_segment", "weights", "before", "after"});
  const std::vector<Rational> t = claim.list("on_segment"), weights = claim.list("weights"),
                              before = claim.list("before"), after = claim.list("after");
  expect((t.size() == 1 || t.size() == 2) && weights.size() == 3 * t.size(), "certificate: one or two common points");
  expect(sgn(t.front()) >= 0 && t.back() <= 1 && (t.size() == 1 || t[0] < t[1]),
         "certificate: the parameters do not rise from 0 to 1");
  const bool one_point = s[0] == s[1];
  std::vector<Triple> common;
  for (std::size_t i = 0; i < t.size(); ++i) {
    common.push_back(along(s[0], t[i], s[1] - s[0]));
    expect(weighted(corners, weights, 3 * i) == common[i], "certificate: the weights give another point");
  }
  if (sgn(t.front()) > 0 || !before.empty()) expect_nothing_before(before, corners, s[0], common.front());
  if ((t.back() < 1 && !one_point) || !after.empty()) expect_nothing_before(after, corners, s[1], common.back());
  expect((t.size() == 1) == (relation == "point"), "truth: relation is wrong");
  if (relation == "point") {
    expect(exact_value(claim.truth["t"], "truth.t") == t[0], "truth: t is wrong");
    expect(exact_triple(claim.truth["point"], "truth.point") == common[0], "truth: point is not at t");
    return;
  }
  const json& overlap = claim.truth["overlap"];
  expect(overlap.is_array() && overlap.size() == 2, "truth.overlap: a list of two");
  expect(exact_triple(overlap[0], "truth.overlap[0]") == common[0] &&
             exact_triple(overlap[1], "truth.overlap[1]") == common[1],
         "truth: overlap is wrong");
  expect(!one_point, "certificate: a segment of length zero is one point");
}

/// The number of independent displacements.
std::size_t rank(const std::vector<Triple>& displacements) {
  std::vector<Triple> independent;
  const Triple zero{0, 0, 0};
  for (const Triple& v : displacements) {
    const bool adds = independent.empty() ? !(v == zero)
                      : independent.size() == 1
                          ? !(cross(independent[0], v) == zero)
                          : independent.size() == 2 && sgn(dot(cross(independent[0], independent[1]), v)) != 0;
    if (adds) independent.push_back(v);
  }
  return independent.size();
}

std::vector<Triple> edge_displacements(const std::vector<Triple>& points) {
  std::vector<Triple> found;
  for (const Triple& p : points) found.push_back(p - points.front());
  return found;
}

/// The corners in the plane; `side` times the others' heights is positive.
std::vector<Triple> in_plane(const Plane& plane, int side, const std::vector<Triple>& corners) {
  std::vector<Triple> kept;
  for (const Triple& p : corners) {
    const int height = side * sgn(plane.at(p));
    expect(height >= 0, "certificate: the plane does not separate");
    if (height == 0) kept.push_back(p);
  }
  return kept;
}

/// The intersection lies in each of the planes, so the remaining corners of both contain it, and so do the planes,
/// lines or points that they span.
std::size_t most_dimensions(const std::vector<Triple>& a, const std::vector<Triple>& b) {
  std::vector<Triple> both = edge_displacements(a);
  for (const Triple& displacement : edge_displacements(b)) both.push_back(displacement);
  return rank(edge_displacements(a)) + rank(edge_displacements(b)) - rank(both);
}

void check_triangle_triangle(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Corners a = points<3>(claim.input["a"], "a"), b = points<3>(claim.input["b"], "b");
  claim.answers({"relation"});
  claim.expect_kind("dimension"), claim.facts({"planes", "on_a", "on_b"});
  const std::vector<Rational> planes = claim.list("planes"), on_a = claim.list("on_a"), on_b = claim.list("on_b");
  expect(planes.size() % 4 == 0, "certificate: four numbers a plane");
  std::vector<Triple> of_a(a.begin(), a.end()), of_b(b.begin(), b.end());
  for (std::size_t i = 0; i < planes.size(); i += 4) {
    const Plane plane{{planes[i], planes[i + 1], planes[i + 2]}, Rational(-planes[i + 3])};
    of_a = in_plane(plane, -1, of_a), of_b = in_plane(plane, 1, of_b);
  }
  expect(on_a.size() % 3 == 0 && on_a.size() == on_b.size(), "certificate: three weights a point");
  std::vector<Triple> common;
  for (std::size_t i = 0; i < on_a.size(); i += 3) {
    common.push_back(weighted(a, on_a, i));
    expect(weighted(b, on_b, i) == common.back(), "certificate: the weights give another point");
  }
  const std::string relation = claim.word("relation");
  if (common.empty()) {
    expect(of_a.empty() || of_b.empty(), "certificate: corners are left of both");
    expect(relation == "none", "truth: relation is wrong");
    return;
  }
  const std::size_t dimension = rank(edge_displacements(common));
  expect(dimension >= most_dimensions(of_a, of_b), "certificate: the planes leave more than the points show");
  expect(relation == (dimension == 0 ? "point" : dimension == 1 ? "segment" : "area"), "truth: relation is wrong");
}

}  // namespace

Checks checks_of_triangles() {
  return {{"segment_triangle", check_segment_triangle}, {"triangle_triangle", check_triangle_triangle}};
}

}  // namespace touchstone::certify
