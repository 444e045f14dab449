// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "oracle/certificates/check_meshes.h"
#include "oracle/certificates/check_obbs.h"
#include "oracle/certificates/check_space.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

/// True if no point of the box is lower over the plane than x, which is one of them: on each axis on which the plane
/// slopes, x is at the lower end.
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
    expect_inside(box, x);
    expect(height < 0, "certificate: the point is not behind the plane");
  } else if (flat) {
    expect(height <= 0, "certificate: the point is in front of the plane");
    expect_flat_axis(claim, box);
  } else {
    expect(is_lowest(box, level, x), "certificate: a point of the box is lower");
    expect(disjoint ? height > 0 : height == 0, "certificate: the height of the point proves another truth");
  }
}

using Position = std::vector<Rational>;

Position operator-(const Position& p, const Position& q) {
  Position displacement;
  for (std::size_t k = 0; k < p.size(); ++k) displacement.push_back(Rational(p[k] - q[k]));
  return displacement;
}
Rational dot(const Position& p, const Position& q) {
  Rational sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum += p[k] * q[k];
  return sum;
}

/// The ends of a segment, or the corners of a triangle, representing their hull. Each has as many coordinates as the
/// first, or `axes` if that is not 0.
using Hull = std::vector<Position>;

Hull hull(const json& value, const std::string& what, std::size_t count, std::size_t axes) {
  expect(value.is_array() && value.size() == count, what + ": a list of " + (count == 2 ? "two" : "three"));
  Hull points;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string of = what + "[" + std::to_string(i) + "]";
    points.push_back(two_or_three(value[i], of));
    if (axes == 0) axes = points[0].size();
    expect(points[i].size() == axes, of + ": as many coordinates as the others");
  }
  return points;
}

/// The point of the hull that the fact's weights give.
Position weighted(const Claim& claim, const char* fact, const Hull& hull) {
  const std::vector<Rational> weights = claim.list(fact);
  expect(weights.size() == hull.size(), "certificate: as many weights as points");
  Position sum(hull[0].size());
  Rational total;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    expect(sgn(weights[i]) >= 0, "certificate: a weight is negative");
    total += weights[i];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weights[i] * hull[i][k];
  }
  expect(total == 1, "certificate: the weights do not add up to 1");
  return sum;
}

/// Requires that no point of the hull is nearer to y than x, which is one of them, nor to any point behind y as seen
/// from x.
void expect_nearest(const Hull& hull, const Position& x, const Position& y) {
  for (const Position& p : hull) expect(sgn(dot(x - y, p - x)) >= 0, "certificate: a point of the hull is nearer");
}

void expect_position(const Claim& claim, const char* name, const Position& x) {
  const std::string what = std::string("truth.") + name;
  const json& value = claim.truth[name];
  expect(value.is_array() && value.size() == x.size(), what + ": as many coordinates as the input");
  for (std::size_t k = 0; k < x.size(); ++k)
    expect(exact_value(value[k], what + "[" + std::to_string(k) + "]") == x[k],
           "truth: " + what.substr(6) + " is wrong");
}

/// x, which the claim's facts give, is the point of the hull that is nearest to p.
void expect_closest(const Claim& claim, const Hull& hull, const Position& x, const Position& p) {
  expect_nearest(hull, x, p);
  expect_position(claim, "point", x);
  expect_distance(claim, dot(x - p, x - p));
}

void check_closest_point(const Claim& claim, const char* shape, std::size_t corners) {
  claim.inputs({"point", shape});
  const Position p = two_or_three(claim.input["point"], "point");
  const Hull points = hull(claim.input[shape], shape, corners, p.size());
  expect(corners == 2 || p.size() == 3, "point: a list of three");
  claim.answers({"point", "squared_distance", "distance"});
  claim.facts({"weights"});
  expect_closest(claim, points, weighted(claim, "weights", points), p);
}
void check_closest_point_on_segment(const Claim& claim) { check_closest_point(claim, "segment", 2); }
void check_closest_point_on_triangle(const Claim& claim) { check_closest_point(claim, "triangle", 3); }

bool parallel(const Position& v, const Position& w) { return dot(v, v) * dot(w, w) == dot(v, w) * dot(v, w); }

/// For parallel segments the parameter on a must be the least: it is 0, or a step back along both would leave b. For
/// others no step keeps the distance.
void expect_first(const Hull& a, const Hull& b, const Position& x, const Position& y) {
  const Position v = a[1] - a[0], w = b[1] - b[0];
  const Rational along = dot(v, w);
  if (sgn(along) == 0 || !parallel(v, w) || x == a[0]) return;
  expect(y == (sgn(along) > 0 ? b[0] : b[1]), "certificate: a pair with a smaller parameter on a is as near");
}

void check_segment_segment_distance(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Hull a = hull(claim.input["a"], "a", 2, 0), b = hull(claim.input["b"], "b", 2, a[0].size());
  claim.answers({"on_a", "on_b", "squared_distance", "distance"});
  claim.facts({"on_a", "on_b"});
  const Position x = weighted(claim, "on_a", a), y = weighted(claim, "on_b", b);
  expect_nearest(a, x, y), expect_nearest(b, y, x), expect_first(a, b, x, y);
  expect_position(claim, "on_a", x), expect_position(claim, "on_b", y);
  expect_distance(claim, dot(x - y, x - y));
}

/// The vertices of a closed convex mesh: the solid is their hull, see check_meshes.h.
Hull convex_solid(const Claim& claim, const char* name) {
  const Mesh surface = mesh(claim.input[name], name);
  outward_planes(surface, name);
  Hull points;
  for (const Triple& p : surface.vertices) points.push_back({p.x, p.y, p.z});
  return points;
}

/// True if no point of the hull comes before x, which is one of its points, along the direction.
bool none_before(const Hull& hull, const Position& x, const Position& direction) {
  return std::all_of(hull.begin(), hull.end(), [&](const Position& p) { return sgn(dot(direction, p - x)) >= 0; });
}

Hull corners_of(const Claim& claim, const char* name) { return hull(claim.input[name], name, 3, 3); }

/// Checks two hulls, which `read` reads.
void check_distance_of(Hull (*read)(const Claim&, const char*), const Claim& claim) {
  claim.inputs({"a", "b"});
  const Hull a = read(claim, "a"), b = read(claim, "b");
  const std::string relation = claim.word("relation");
  const bool apart = relation == "apart";
  expect(apart || relation == "meeting", "truth: relation is wrong");
  if (apart) {
    claim.answers({"relation", "on_a", "on_b", "squared_distance", "distance"});
    claim.facts({"on_a", "on_b", "first"});
  } else {
    claim.answers({"relation", "squared_distance", "distance"});
    claim.expect_kind("common_point"), claim.facts({"on_a", "on_b"});
  }
  const Position x = weighted(claim, "on_a", a), y = weighted(claim, "on_b", b);
  if (!apart) {
    expect(x == y, "certificate: the point is not in both");
    for (const char* name : {"squared_distance", "distance"})
      expect(sgn(exact_value(claim.truth[name], std::string("truth.") + name)) == 0,
             std::string("truth: ") + name + " is wrong");
    return;
  }
  expect_nearest(a, x, y), expect_nearest(b, y, x);
  expect(x != y, "certificate: the points prove another truth");
  const Position first = claim.list("first");
  expect(first.size() == 3, "certificate.first: a list of three");
  const bool proved = none_before(a, x, first) && none_before(b, y, x - a[0] - first);
  expect(proved, "certificate: a pair nearer to the first vertex of a may be as near");
  expect_position(claim, "on_a", x), expect_position(claim, "on_b", y);
  expect_distance(claim, dot(x - y, x - y));
}

void check_convex_distance(const Claim& claim) { check_distance_of(convex_solid, claim); }
void check_triangle_triangle_distance(const Claim& claim) { check_distance_of(corners_of, claim); }

/// A round convex solid: all that is no farther from its core than a radius. A core that counts as a solid by itself, a
/// box, or a triangle that a round solid meets, has none.
struct Round {
  Hull core;
  std::vector<Rational> radii;
  std::optional<Obb> box{};      ///< the core is its corners
  std::optional<Box> aligned{};  ///< the same; it has no interior if it is flat

  /// The point of the core that a fact gives, by weights or coefficients.
  Position at(const Claim& claim, const char* fact) const {
    if (!box && !aligned) return weighted(claim, fact, core);
    std::vector<Rational> coefficients = claim.list(fact);
    expect(coefficients.size() == 3, std::string("certificate.") + fact + ": a list of three");
    if (aligned) {
      expect(aligned->holds(coefficients), "certificate: the point is not in the box");
      return coefficients;
    }
    for (const Rational& each : coefficients) expect(abs(each) <= 1, "certificate: the point is not in the box");
    const Triple p = box->at(coefficients);
    return {p.x, p.y, p.z};
  }
};

Round round_ball(const Claim& claim, const char* name) {
  const Ball solid = ball(claim.input[name], name);
  return {{{solid.center.x, solid.center.y, solid.center.z}}, {solid.radius}};
}
Round round_triangle(const Claim& claim, const char* name) { return {hull(claim.input[name], name, 3, 3), {}}; }
Round round_capsule(const Claim& claim, const char* name) {
  const json& value = claim.input[name];
  const std::string what = name;
  only(value, what, {"segment", "radius"});
  Hull segment = hull(value["segment"], what + ".segment", 2, 3);
  const Rational radius = number(value["radius"], what + ".radius");
  expect(sgn(radius) >= 0, what + ".radius: radius >= 0");
  return {std::move(segment), {radius}};
}
Round round_box(const Claim& claim, const char* name) {
  const Obb box = obb(claim.input[name], name);
  Hull corners;
  for (const int r : {-1, 1})
    for (const int s : {-1, 1})
      for (const int t : {-1, 1}) {
        const Triple p = box.at({r, s, t});
        corners.push_back({p.x, p.y, p.z});
      }
  return {std::move(corners), {}, box};
}

Round round_aabb(const Claim& claim, const char* name) {
  const Box box = box_in_space(claim.input[name], name);
  Hull corners;
  for (const auto& x : {box.min[0], box.max[0]})
    for (const auto& y : {box.min[1], box.max[1]})
      for (const auto& z : {box.min[2], box.max[2]}) corners.push_back({x, y, z});
  return {std::move(corners), {}, std::nullopt, box};
}

Round round_convex(const Claim& claim, const char* name) { return {convex_solid(claim, name), {}}; }

/// Checks the contact of two round convex solids, or of one and a triangle, from points x and y of the cores: no part
/// of one core is nearer to the other than they are; and the sum of the radii. If a point of a box is nearer to the
/// other core than that, points of its interior are.
void expect_contact(const Claim& claim, const Round& a, const Position& x, const Round& b, const Position& y) {
  const std::string kind = claim.kind();
  const Rational square = dot(x - y, x - y);
  std::vector<Rational> radii = a.radii;
  radii.insert(radii.end(), b.radii.begin(), b.radii.end());
  Rational sum;
  for (const Rational& radius : radii) sum += radius;
  const int beyond = sgn(Rational(square - sum * sum));
  bool interiors = std::all_of(radii.begin(), radii.end(), [](const Rational& r) { return sgn(r) > 0; });
  for (const Round* solid : {&a, &b})
    for (std::size_t k = 0; solid->aligned && k < 3; ++k)
      interiors = interiors && solid->aligned->min[k] < solid->aligned->max[k];
  if (kind == "near_points") {
    expect(beyond < 0 && interiors, "certificate: the points are no common interior");
  } else if (kind == "no_interior") {
    expect(beyond <= 0 && !interiors, "certificate: the points do not touch, or there are interiors");
  } else {
    expect_nearest(a.core, x, y), expect_nearest(b.core, y, x);
    expect(kind == "tangent" ? beyond == 0 : beyond > 0, "certificate: the distance proves another truth");
  }
}

/// The kind must match the contact. A core that is a point needs no fact.
void check_contact(const Claim& claim, const Round& a, const Round& b) {
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  expect(contact == "disjoint" || contact == "touching" || contact == "overlapping", "truth: contact is wrong");
  expect(contact == "disjoint"   ? kind == "nearest_points"
         : contact == "touching" ? kind == "tangent" || kind == "no_interior"
                                 : kind == "near_points",
         wrong_kind);
  if (a.core.size() == 1) {
    const char* const fact = b.box ? "coefficients" : "weights";
    claim.facts({fact});
    return expect_contact(claim, a, a.core[0], b, b.at(claim, fact));
  }
  claim.facts({"on_a", "on_b"});
  const Position x = a.at(claim, "on_a"), y = b.at(claim, "on_b");
  expect_contact(claim, a, x, b, y);
}

/// The check of the contact of two inputs, which are read so.
Check contact(const char* a, Round (*read_a)(const Claim&, const char*), const char* b,
              Round (*read_b)(const Claim&, const char*)) {
  return [=](const Claim& claim) {
    claim.inputs({a, b});
    const Round first = read_a(claim, a), second = read_b(claim, b);
    check_contact(claim, first, second);
  };
}

void check_closest_point_on_obb(const Claim& claim) {
  claim.inputs({"point", "obb"});
  const Triple p = point_in_space(claim.input["point"], "point");
  const Round box = round_box(claim, "obb");
  claim.answers({"point", "squared_distance", "distance"});
  claim.facts({"coefficients"});
  expect_closest(claim, box.core, box.at(claim, "coefficients"), {p.x, p.y, p.z});
}

}  // namespace

Checks checks_of_closest() {
  return {{"aabb_plane", check_aabb_plane},
          {"closest_point_on_segment", check_closest_point_on_segment},
          {"closest_point_on_triangle", check_closest_point_on_triangle},
          {"closest_point_on_obb", check_closest_point_on_obb},
          {"segment_segment_distance", check_segment_segment_distance},
          {"convex_distance", check_convex_distance},
          {"triangle_triangle_distance", check_triangle_triangle_distance},
          {"sphere_triangle", contact("sphere", round_ball, "triangle", round_triangle)},
          {"sphere_capsule", contact("sphere", round_ball, "capsule", round_capsule)},
          {"capsule_capsule", contact("a", round_capsule, "b", round_capsule)},
          {"sphere_obb", contact("sphere", round_ball, "obb", round_box)},
          {"capsule_obb", contact("capsule", round_capsule, "obb", round_box)},
          {"capsule_aabb", contact("capsule", round_capsule, "aabb", round_aabb)},
          {"capsule_triangle", contact("capsule", round_capsule, "triangle", round_triangle)},
          {"sphere_convex", contact("sphere", round_ball, "mesh", round_convex)},
          {"capsule_convex", contact("capsule", round_capsule, "mesh", round_convex)}};
}

}  // namespace touchstone::certify
