// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>
#include <vector>

#include "oracle/certificates/check_meshes.h"
#include "oracle/certificates/check_solids.h"
#include "oracle/certificates/check_space.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

/// The indices of the vertices that are farthest along a direction, in ascending order, and their height.
struct Farthest {
  std::vector<std::size_t> level;
  Rational height;

  Farthest(const std::vector<Triple>& vertices, const Triple& direction) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Rational here = dot(direction, vertices[i]);
      if (level.empty() || here > height) level.clear(), height = here;
      if (here == height) level.push_back(i);
    }
  }
  const char* part(const std::vector<Triple>& vertices) const {
    const Triple none{0, 0, 0};
    Triple edge = none;
    for (const std::size_t i : level) {
      const Triple span = vertices[i] - vertices[level[0]];
      if (edge == none) edge = span;
      if (!(cross(edge, span) == none)) return "face";
    }
    return edge == none ? "vertex" : "edge";
  }
};

/// b reaches along the direction beyond the beginning of a by height / |direction|.
struct Reach {
  Triple direction;
  Farthest of_a, of_b;
  Rational height, square;

  Reach(const std::vector<Triple>& a, const std::vector<Triple>& b, const Triple& along)
      : direction(along),
        of_a(a, Triple{0, 0, 0} - along),
        of_b(b, along),
        height(of_a.height + of_b.height),
        square(dot(along, along)) {}
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> levels() const { return {of_a.level, of_b.level}; }
};

Triple weighted(const Claim& claim, const char* fact, const std::vector<Triple>& points) {
  const std::vector<Rational> weights = claim.list(fact);
  expect(weights.size() == points.size(), "certificate: as many weights as points");
  Rational total;
  Triple sum{0, 0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect(sgn(weights[i]) >= 0, "certificate: a weight is negative");
    total += weights[i], sum = along(sum, weights[i], points[i]);
  }
  expect(total == 1, "certificate: the weights do not add up to 1");
  return sum;
}

/// The differences of the vertices that `of_a` and `of_b` name, with the triangles of `faces`.
Mesh hull_of_differences(const Claim& claim, const std::vector<Triple>& a, const std::vector<Triple>& b) {
  const std::vector<Rational> of_a = claim.list("of_a"), of_b = claim.list("of_b"), corners = claim.list("faces");
  expect(of_a.size() == of_b.size(), "certificate: as many vertices of both");
  expect(!corners.empty() && corners.size() % 3 == 0, "certificate: three corners of each face");
  Mesh hull;
  for (std::size_t k = 0; k < of_a.size(); ++k)
    hull.vertices.push_back(b[index(of_b[k], b.size())] - a[index(of_a[k], a.size())]);
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    const auto corner = [&](std::size_t i) { return index(corners[k + i], hull.vertices.size()); };
    hull.faces.push_back({corner(0), corner(1), corner(2)});
    hull.named.push_back({hull.faces.back()[0], hull.faces.back()[1], hull.faces.back()[2]});
    hull.face_of.push_back(k / 3);
  }
  return hull;
}

/// Returns the reach of the face that the certificate names. The solid of these faces is one of differences, and holds
/// all of them: it is that of all translations that leave a common point. The least translation out of it ends at the
/// foot of the perpendicular on one of their planes; where the origin is on several, each of these has a direction.
Reach nearest_face(const Claim& claim, const std::vector<Triple>& a, const std::vector<Triple>& b) {
  std::vector<Reach> faces;
  for (const Plane& face : outward_planes(hull_of_differences(claim, a, b), "certificate")) {
    faces.emplace_back(a, b, face.normal);
    expect(faces.back().height == -face.offset, "certificate: a difference is beyond a face");
    expect(sgn(face.offset) <= 0, "certificate: the origin is outside");
  }
  const Reach& found = faces[index(claim.single("face"), faces.size())];
  for (const Reach& other : faces) {
    const Rational here = other.height * other.height * found.square,
                   there = found.height * found.height * other.square;
    expect(here >= there, "certificate: a face is nearer");
    expect(here > there || found.levels() <= other.levels(), "certificate: a face of earlier vertices is as near");
  }
  return found;
}

/// The cores have the point that the weights give, and no three differences between vertices of one are independent:
/// the translations that leave a common point lie in a plane or on a line through the origin. Those off it may be as
/// short as any, so that each direction at a right angle to it is as deep as any: 0. The last of these in lexicographic
/// order is the part of an axis, of the first that has one.
Reach last_across(const Claim& claim, const std::vector<Triple>& a, const std::vector<Triple>& b) {
  expect(weighted(claim, "on_a", a) == weighted(claim, "on_b", b), "certificate: two points that are not the same");
  const Triple none{0, 0, 0};
  Triple line = none, normal = none;
  for (const std::vector<Triple>* vertices : {&a, &b}) {
    for (const Triple& vertex : *vertices) {
      const Triple span = vertex - vertices->front();
      expect(sgn(dot(normal, span)) == 0, "certificate: the differences have an inside");
      if (line == none) line = span;
      else if (normal == none) normal = cross(line, span);
    }
  }
  Triple found = none;
  for (const Triple& axis : {Triple{1, 0, 0}, Triple{0, 1, 0}, Triple{0, 0, 1}}) {
    if (!(found == none)) break;
    found = !(normal == none) ? along(none, dot(axis, normal), normal)
            : line == none    ? axis
                              : cross(line, cross(axis, line));
  }
  return {a, b, found};
}

/// Along the displacement between the points that the weights give.
Reach shortest_displacement(const Claim& claim, const std::vector<Triple>& a, const std::vector<Triple>& b) {
  const Triple x = weighted(claim, "on_a", a), y = weighted(claim, "on_b", b);
  expect(!(x == y), "certificate: no direction");
  const Reach found(a, b, x - y);
  expect(found.height == -found.square, "certificate: the displacement is longer than its gap");
  return found;
}

/// x = p + q sqrt(r): x - rational has that square, and that sign or is 0.
void expect_root(const std::string& name, const json& value, const Rational& rational, const Rational& squared,
                 int sign) {
  const Surd rest = exact_surd(value, "truth." + name) + Rational(-rational);
  const bool right = certify::sign(square(rest) + Rational(-squared)) == 0 && certify::sign(rest) * sign >= 0;
  expect(right, "truth: " + name + " is wrong");
}

void expect_coordinates(const Claim& claim, const std::string& name, const Triple& direction, const Rational& rational,
                        const Rational& squared) {
  const json& value = claim.truth[name];
  expect(value.is_array() && value.size() == 3, "truth." + name + ": a list of three");
  const Rational numbers[]{direction.x, direction.y, direction.z};
  for (std::size_t k = 0; k < 3; ++k)
    expect_root(numbered(name, k), value[k], Rational(numbers[k] * rational),
                Rational(numbers[k] * numbers[k] * squared), sgn(numbers[k]));
}

/// The mesh is a solid, or one to three vertices without a face, whose hull is the core.
Mesh core(const json& value, const std::string& what) {
  const bool without_faces =
      value.is_object() && value.contains("faces") && value["faces"] == json::array() && !value.contains("cut");
  if (without_faces) {
    const Mesh found = listed_faces(value, what);
    if (!found.vertices.empty() && found.vertices.size() <= 3) return found;
  }
  return mesh(value, what);
}

void check_penetration(const Claim& claim) {
  claim.inputs({"a", "b", "radius_a", "radius_b"});
  const Mesh a = core(claim.input["a"], "a"), b = core(claim.input["b"], "b");
  if (!a.faces.empty()) outward_planes(a, "a");
  if (!b.faces.empty()) outward_planes(b, "b");
  Rational radii;
  for (const char* name : {"radius_a", "radius_b"}) {
    const Rational radius = number(claim.input[name], name);
    expect(sgn(radius) >= 0, std::string(name) + ": radius >= 0");
    radii += radius;
  }
  claim.answers({"contact", "depth", "direction", "translation", "feature"});
  const bool meeting = claim.kind() == "difference_hull", flat = claim.kind() == "common_point";
  if (meeting) {
    claim.facts({"face", "of_a", "of_b", "faces"});
  } else {
    if (!flat) claim.expect_kind("nearest_points");
    claim.facts({"on_a", "on_b"});
  }
  const Reach found = meeting ? nearest_face(claim, a.vertices, b.vertices)
                      : flat  ? last_across(claim, a.vertices, b.vertices)
                              : shortest_displacement(claim, a.vertices, b.vertices);
  const Rational of_cores(found.height * found.height / found.square);
  const int core_sign = sgn(found.height);
  const int sign = core_sign >= 0 ? sgn(Rational(radii + of_cores)) : sgn(Rational(radii * radii - of_cores));
  expect(claim.word("contact") == (sign > 0    ? "overlapping"
                                   : sign == 0 ? "touching"
                                               : "disjoint"),
         "truth: contact is wrong");
  expect_root("depth", claim.truth["depth"], radii, of_cores, core_sign);
  expect_coordinates(claim, "direction", found.direction, 0, Rational(1 / found.square));
  expect_coordinates(claim, "translation", found.direction, Rational(found.height / found.square),
                     Rational(radii * radii / found.square));
  only(claim.truth["feature"], "truth.feature", {"a", "b"});
  const json parts{{"a", found.of_a.part(a.vertices)}, {"b", found.of_b.part(b.vertices)}};
  expect(claim.truth["feature"] == parts, "truth: feature is wrong");
}

}  // namespace

Checks checks_of_penetration() { return {{"penetration", check_penetration}}; }

}  // namespace touchstone::certify
