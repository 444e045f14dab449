// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "oracle/certificates/check_meshes.h"
#include "oracle/certificates/check_solids.h"
#include "oracle/certificates/check_surd.h"
#include "oracle/certificates/check_triangles.h"

namespace touchstone::certify {
namespace {

const char* const no_proof = "certificate: the kind does not hold";

/// |c + t v|^2 - r^2 for the position c and velocity v of a relative to b and the sum r of the radii: at most 0 if the
/// balls meet.
Quadratic squared_gap(const Claim& claim) {
  const Ball a = ball(claim.input["a"], "a"), b = ball(claim.input["b"], "b");
  const Triple velocity_a = point_in_space(claim.input["velocity_a"], "velocity_a"),
               velocity_b = point_in_space(claim.input["velocity_b"], "velocity_b");
  const Triple c = a.center - b.center, v = velocity_a - velocity_b;
  const Rational r(a.radius + b.radius);
  return {Rational(dot(c, c) - r * r), Rational(2 * dot(c, v)), dot(v, v)};
}

/// Requires that the truth is the first zero in [0, 1] of f, which is recomputed; 0 if f(0) <= 0.
void prove_first_zero(const Claim& claim, const Quadratic& f) {
  const std::string relation = claim.word("relation"), kind = claim.kind();
  expect(relation == "hit" || relation == "never", "truth: relation is wrong");
  claim.facts({"polynomial"});
  const Triple claimed = triple(claim, "polynomial");
  expect(claimed == Triple{f.constant, f.linear, f.square}, "certificate: the polynomial is wrong");
  if (relation == "never") {
    claim.answers({"relation"});
    expect(f.proved_positive(kind, /*ends=*/true), no_proof);
    return;
  }
  claim.answers({"relation", "t"});
  const Surd t = exact_surd(claim.truth["t"], "truth.t");
  if (kind == "start") {
    expect(sgn(f.constant) <= 0, no_proof);
    expect(sign(t) == 0, "truth: t is wrong");
    return;
  }
  expect(kind == "first_root", wrong_kind);
  expect(sgn(f.constant) > 0, no_proof);
  // f' grows and is at most 0 at t, so f falls until its zero at t: before, it is positive.
  const bool first = sign(t) > 0 && sign(t + Rational(-1)) <= 0 && sign(f.at(t)) == 0 && sign(f.slope_at(t)) <= 0;
  expect(first, "truth: t is wrong");
}

void check_swept_sphere_sphere(const Claim& claim) {
  claim.inputs({"a", "b", "velocity_a", "velocity_b"});
  prove_first_zero(claim, squared_gap(claim));
}

/// Requires the same of f = (e + t N . v)^2 - r^2 N . N, e being the height of a center over the plane at the start: at
/// most 0 where the ball around it meets the plane.
void prove_approach(const Claim& claim, const Plane& level, const Rational& e, const Rational& radius,
                    const Triple& velocity) {
  const Rational rise = dot(level.normal, velocity), reach(radius * radius * dot(level.normal, level.normal));
  prove_first_zero(claim, {Rational(e * e - reach), Rational(2 * e * rise), Rational(rise * rise)});
}

void check_swept_sphere_plane(const Claim& claim) {
  claim.inputs({"sphere", "velocity", "plane"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  const Plane level = plane(claim.input["plane"], "plane");
  prove_approach(claim, level, level.at(sphere.center), sphere.radius, velocity);
}

/// The point of the segment that is nearest to the plane stays the nearest until the first contact, as both ends are on
/// one side; or it is on the plane.
void check_swept_capsule_plane(const Claim& claim) {
  claim.inputs({"capsule", "velocity", "plane"});
  const auto [ends, radius] = capsule_in_space(claim.input["capsule"], "capsule");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  const Plane level = plane(claim.input["plane"], "plane");
  const Rational a = level.at(ends[0]), b = level.at(ends[1]);
  const Rational e(sgn(a) * sgn(b) <= 0 ? Rational(0) : abs(a) <= abs(b) ? a : b);
  prove_approach(claim, level, e, radius, velocity);
}

/// A moving ball and a box at rest, on one axis.
struct CenterOnAxis {
  Rational center, velocity, min, max;
  /// The coordinate of the center at t, less a side of the box.
  Surd beyond(const Rational& side, const Surd& t) const { return t * velocity + Rational(center - side); }
};

/// Requires that at t the center is on these sides of the box, as far from it as the radius, and comes in on some axis.
/// With n the displacement from the nearest point of the box, half the slope of f at t is n . v <= 0. Before t,
/// n . (c - x) was n . n = r^2 or more for every point x of the box, so that no x was as near as r, but x = c - n; and
/// that was not in the box on the axis on which the center comes in.
void expect_contact_on_sides(const std::vector<CenterOnAxis>& axes, const Rational& radius,
                             const std::vector<Rational>& sides, const Surd& t) {
  for (const Rational& side : sides) expect(abs(side) == 1 || sgn(side) == 0, "certificate.sides: -1, 0 or 1");
  Quadratic f{Rational(-radius * radius), 0, 0};
  bool comes_in = false, in_place = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const CenterOnAxis& axis = axes[k];
    const int to_min = sign(axis.beyond(axis.min, t)), to_max = sign(axis.beyond(axis.max, t)), v = sgn(axis.velocity);
    comes_in = comes_in || (v > 0 && to_min <= 0) || (v < 0 && to_max >= 0);
    in_place = in_place && (sides[k] == -1 ? to_min <= 0 : sides[k] == 1 ? to_max >= 0 : to_min >= 0 && to_max <= 0);
    if (sgn(sides[k]) == 0) continue;
    const Rational gap(axis.center - (sgn(sides[k]) < 0 ? axis.min : axis.max));
    f.constant += gap * gap, f.linear += 2 * gap * axis.velocity, f.square += axis.velocity * axis.velocity;
  }
  expect(in_place, "certificate: the center is on other sides at t");
  const bool first = sign(t) > 0 && sign(t + Rational(-1)) <= 0 && sign(f.at(t)) == 0 && sign(f.slope_at(t)) <= 0;
  expect(first && comes_in, "truth: t is wrong");
}

Triple farthest_along(const Triple& n, const Box& box) {
  const auto side = [&box](const Rational& along, std::size_t k) { return sgn(along) > 0 ? box.max[k] : box.min[k]; };
  return {side(n.x, 0), side(n.y, 1), side(n.z, 2)};
}
using Polygon = std::vector<Triple>;
Triple farthest_along(const Triple& n, const Polygon& corners) {
  return *std::max_element(corners.begin(), corners.end(),
                           [&n](const Triple& p, const Triple& q) { return dot(n, p) < dot(n, q); });
}

/// Requires that along the fact `normal` the ball is beyond all of the solid at the start and at the end.
template <class Solid>
void expect_apart(const Claim& claim, const Ball& ball, const Triple& velocity, const Solid& solid) {
  const Triple n = triple(claim, "normal"), farthest = farthest_along(n, solid);
  const Rational start = dot(n, ball.center - farthest), end(start + dot(n, velocity)),
                 reach(square(ball.radius) * dot(n, n));
  const bool apart = sgn(start) > 0 && sgn(end) > 0 && square(start) > reach && square(end) > reach;
  expect(apart, "certificate: the axis does not separate");
}

/// Requires that the fact `point` is in the ball at the start and in the box.
void expect_common_point(const Claim& claim, const Ball& ball, const Box& box) {
  const Triple point = triple(claim, "point"), way = ball.center - point;
  const bool common = box.holds({point.x, point.y, point.z}) && dot(way, way) <= square(ball.radius);
  expect(common, "certificate: the point is not in both");
}

void check_swept_sphere_aabb(const Claim& claim) {
  claim.inputs({"sphere", "velocity", "aabb"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Triple v = point_in_space(claim.input["velocity"], "velocity"), c = sphere.center;
  const Box box = box_in_space(claim.input["aabb"], "aabb");
  const std::string relation = claim.word("relation"), kind = claim.kind();
  if (relation == "never") {
    claim.answers({"relation"}), expect(kind == "separating_axis", wrong_kind), claim.facts({"normal"});
    return expect_apart(claim, sphere, v, box);
  }
  expect(relation == "hit", "truth: relation is wrong"), claim.answers({"relation", "t"});
  const Surd t = exact_surd(claim.truth["t"], "truth.t");
  if (kind == "start") {
    claim.facts({"point"}), expect_common_point(claim, sphere, box);
    return expect(sign(t) == 0, "truth: t is wrong");
  }
  expect(kind == "first_contact", wrong_kind), claim.facts({"sides"});
  const Triple sides = triple(claim, "sides");
  const auto& [min, max] = box;
  expect_contact_on_sides({{c.x, v.x, min[0], max[0]}, {c.y, v.y, min[1], max[1]}, {c.z, v.z, min[2], max[2]}},
                          sphere.radius, {sides.x, sides.y, sides.z}, t);
}

/// The displacement from the nearest point of a corner, of the line of an edge or of the plane of a face to the center
/// that moves, times `scale`: start + t rise; and the heights of the center, not negative where it is over that part.
struct Displacement {
  Triple start, rise;
  Rational scale{1};
  std::vector<std::pair<Triple, Triple>> sides;  ///< a normal and a point
};
Displacement displacement_from(const Polygon& corners, const std::vector<std::size_t>& part, const Triple& center,
                               const Triple& v) {
  const Triple none{0, 0, 0}, w = center - corners[part[0]];
  if (part.size() == 1) return {w, v, 1, {}};
  const Triple e = corners[part[1]] - corners[part[0]];
  if (part.size() == 2) {
    const Rational square = dot(e, e);
    expect(sgn(square) > 0, "certificate: the edge has no length");
    const auto across = [&](const Triple& d) { return along(along(none, square, d), Rational(-dot(d, e)), e); };
    return {across(w), across(v), square, {{e, corners[part[0]]}, {none - e, corners[part[1]]}}};
  }
  const Triple n = cross(e, corners[2] - corners[0]);
  expect(sgn(dot(n, n)) > 0, "certificate: the polygon has no area");
  Displacement found{along(none, dot(w, n), n), along(none, dot(v, n), n), dot(n, n), {}};
  for (std::size_t k = 0; k < corners.size(); ++k)
    found.sides.emplace_back(cross(n, corners[(k + 1) % corners.size()] - corners[k]), corners[k]);
  return found;
}

/// Requires that at t the center is over the part of the polygon that the fact `corners` names, that no corner is
/// beyond that, that it is as far from there as the radius, and does not go away.
///
/// With d the displacement at t, half the slope of its square is d . v <= 0. Before t, d . (c - p) was d . d = r^2 or
/// more for every point p of the polygon, so no p was nearer than r; and none was as near if d . v < 0. If that is 0,
/// p = c - d alone was; but that was not in the polygon, if along the fact `normal` the velocity leads up, and all
/// corners are as high as c - d at t.
void expect_contact_on_polygon(const Claim& claim, const Ball& ball, const Triple& v, const Polygon& corners,
                               const Surd& t) {
  named(claim, "corners", corners);
  std::vector<std::size_t> part;
  for (const Rational& place : claim.list("corners")) part.push_back(place.get_num().get_ui());
  const bool in_order = std::adjacent_find(part.begin(), part.end(), std::greater_equal<>()) == part.end();
  expect(!part.empty() && in_order, "certificate.corners: in ascending order");
  const Triple& c = ball.center;
  const Displacement d = displacement_from(corners, part, c, v);
  bool over = true;
  for (const auto& [n, p] : d.sides) over = over && sign(t * dot(n, v) + dot(n, c - p)) >= 0;
  for (const Triple& p : corners) {
    const Triple from = p - corners[part[0]];
    over = over && sign(t * dot(d.rise, from) + dot(d.start, from)) <= 0;
  }
  expect(over, "certificate: the center is over another part at t");
  const Rational reach = ball.radius * d.scale;
  const Quadratic f{Rational(dot(d.start, d.start) - reach * reach), Rational(2 * dot(d.start, d.rise)),
                    dot(d.rise, d.rise)};
  const int slope = sign(f.slope_at(t));
  const Triple m = triple(claim, "normal");
  bool leaves = sgn(dot(m, v)) > 0;
  for (const Triple& p : corners) {
    const Rational start(d.scale * dot(m, p - c) + dot(m, d.start)), rise(dot(m, d.rise) - d.scale * dot(m, v));
    leaves = leaves && sign(t * rise + start) >= 0;
  }
  const bool first = sign(t) > 0 && sign(t + Rational(-1)) <= 0 && sign(f.at(t)) == 0;
  expect(first && (slope < 0 || (slope == 0 && leaves)), "truth: t is wrong");
}

/// Requires that t is the first contact, by a common point at the start or the part that is met later.
void expect_hit(const Claim& claim, const Ball& sphere, const Triple& velocity, const Polygon& corners, const Surd& t) {
  if (claim.kind() != "start") {
    claim.expect_kind("first_contact");
    return expect_contact_on_polygon(claim, sphere, velocity, corners, t);
  }
  const std::vector<Rational> weights = claim.list("weights");
  expect(weights.size() == corners.size(), "certificate: as many weights as points");
  const Triple way = sphere.center - weighted(corners, weights, 0);
  expect(dot(way, way) <= square(sphere.radius), "certificate: the point is not in both");
  expect(sign(t) == 0, "truth: t is wrong");
}

/// Requires what is true of a moving ball and a convex polygon at rest, its corners in order.
void prove_contact_with_polygon(const Claim& claim, const Ball& ball, const Triple& velocity, const Polygon& corners) {
  const std::string relation = claim.word("relation"), kind = claim.kind();
  if (relation == "never") {
    claim.answers({"relation"}), expect(kind == "separating_axis", wrong_kind), claim.facts({"normal"});
    return expect_apart(claim, ball, velocity, corners);
  }
  expect(relation == "hit", "truth: relation is wrong"), claim.answers({"relation", "t"});
  const Surd t = exact_surd(claim.truth["t"], "truth.t");
  if (kind == "start") claim.facts({"weights"});
  else claim.expect_kind("first_contact"), claim.facts({"corners", "normal"});
  expect_hit(claim, ball, velocity, corners, t);
}

void check_swept_sphere_triangle(const Claim& claim) {
  claim.inputs({"sphere", "velocity", "triangle"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  const Corners corners = points<3>(claim.input["triangle"], "triangle");
  prove_contact_with_polygon(claim, sphere, velocity, {corners.begin(), corners.end()});
}

/// Each face is proved once, by a normal along which it is missed or by the time of its first contact.
void check_swept_sphere_mesh(const Claim& claim) {
  claim.inputs({"sphere", "velocity", "mesh"});
  const Ball sphere = ball(claim.input["sphere"], "sphere");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  const Mesh surface = listed_faces(claim.input["mesh"], "mesh");
  const std::string relation = claim.word("relation");
  expect(relation == "hit" || relation == "never", "truth: relation is wrong");
  if (relation == "hit") claim.answers({"relation", "t", "face"});
  else claim.answers({"relation"});
  claim.expect_kind("faces"), claim.facts({"missed", "met"});
  std::set<std::size_t> proved;
  const auto corners_of = [&](const Rational& value) {
    const std::size_t face = index(value, surface.faces.size());
    expect(proved.insert(face).second, "certificate: a face is proved twice");
    const auto& [a, b, c] = surface.faces[face];
    return Polygon{surface.vertices[a], surface.vertices[b], surface.vertices[c]};
  };
  for (const Claim& proof : claim.proofs("missed")) {
    proof.expect_kind("separating_axis"), proof.facts({"normal", "faces"});
    for (const Rational& face : proof.list("faces")) expect_apart(proof, sphere, velocity, corners_of(face));
  }
  std::optional<std::pair<Surd, Rational>> first;
  for (const Claim& proof : claim.proofs("met")) {
    if (proof.kind() == "start") proof.facts({"face", "weights", "time"});
    else proof.expect_kind("first_contact"), proof.facts({"face", "corners", "normal", "time"});
    const Triple time = triple(proof, "time");
    expect(sgn(time.z) >= 0, "certificate.time: the root of a negative number");
    const Surd t{time.x, time.y, time.z};
    const Rational face = proof.single("face");
    expect_hit(proof, sphere, velocity, corners_of(face), t);
    const int order = first ? compare(t, first->first) : -1;
    if (order < 0 || (order == 0 && face < first->second)) first = {t, face};
  }
  expect(proved.size() == surface.faces.size(), "certificate: a face is left out");
  expect(relation == (first ? "hit" : "never"), "truth: relation is wrong");
  if (!first) return;
  expect(compare(exact_surd(claim.truth["t"], "truth.t"), first->first) == 0, "truth: t is wrong");
  const json& face = claim.truth["face"];
  const std::size_t named = surface.face_of[index(first->second, surface.faces.size())];
  expect(face.is_number_unsigned() && named == face.get<std::uint64_t>(), "truth: face is wrong");
}

/// The capsules meet where the first end of a is no farther from the points of b, less the displacements along a, than
/// both radii together.
void check_swept_capsule_capsule(const Claim& claim) {
  claim.inputs({"a", "b", "velocity"});
  const auto [of_a, r] = capsule_in_space(claim.input["a"], "a");
  const auto [of_b, s] = capsule_in_space(claim.input["b"], "b");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity"), u = of_a[1] - of_a[0];
  prove_contact_with_polygon(claim, {of_a[0], Rational(r + s)}, velocity, {of_b[0], of_b[1], of_b[1] - u, of_b[0] - u});
}

}  // namespace

Checks checks_of_sweeps() {
  return {
      {"swept_sphere_sphere", check_swept_sphere_sphere},     {"swept_sphere_plane", check_swept_sphere_plane},
      {"swept_capsule_plane", check_swept_capsule_plane},     {"swept_sphere_aabb", check_swept_sphere_aabb},
      {"swept_sphere_triangle", check_swept_sphere_triangle}, {"swept_sphere_mesh", check_swept_sphere_mesh},
      {"swept_capsule_capsule", check_swept_capsule_capsule}};
}

}  // namespace touchstone::certify
