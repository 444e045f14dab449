// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "catalogue/families/numbers.h"
#include "proptests/box_laws.h"
#include "proptests/closest_laws.h"
#include "reference/mixed/convex_distance.h"
#include "robust/mixed/sphere_capsule.h"
#include "robust/mixed/sphere_convex.h"
#include "robust/mixed/sphere_triangle.h"
#include "robust/volumes/sphere_aabb.h"
#include "robust/volumes/sphere_obb.h"
#include "robust/volumes/sphere_sphere.h"

/// Laws of the contact of two solids, one or both of which have a radius. Symmetries that a row declares (exact maps,
/// scaling, exchanged arguments) are tested for every operation.
namespace touchstone::proptests {

/// Other ways to write the same solid.
inline std::vector<Sphere3d> rewritten(const Sphere3d&) { return {}; }
inline std::vector<Capsule3d> rewritten(const Capsule3d& c) { return {{{c.segment.b, c.segment.a}, c.radius}}; }
inline std::vector<Triangle3d> rewritten(const Triangle3d& t) { return {{t.b, t.c, t.a}, {t.c, t.b, t.a}}; }
inline std::vector<Obb3d> rewritten(const Obb3d& box) { return {std::get<0>(in_another_order<0>(std::tuple{box}))}; }
inline std::vector<Aabb3d> rewritten(const Aabb3d&) { return {}; }
inline std::vector<Meshd> rewritten(const Meshd& mesh) {
  Meshd turned = mesh;
  turned.polygons.clear(), turned.vertices.push_back(mesh.vertices[mesh.faces[0].a]);
  for (Face& f : turned.faces) f = {f.c, f.b, f.a};
  std::reverse(turned.faces.begin(), turned.faces.end());
  return {turned};
}

/// Balls at the ends and corners of a solid, which are parts of it. A box has them where its corners are exact.
inline std::vector<Sphere3d> balls_in(const Sphere3d&) { return {}; }
inline std::vector<Sphere3d> balls_in(const Capsule3d& c) { return {{c.segment.a, c.radius}, {c.segment.b, c.radius}}; }
inline std::vector<Sphere3d> balls_in(const Triangle3d& t) { return {{t.a, 0}, {t.b, 0}, {t.c, 0}}; }
inline std::vector<Sphere3d> balls_in(const Obb3d& box) {
  std::vector<Sphere3d> balls;
  if (!on_lattice(std::tuple{box})) return balls;
  for (const Point3d& corner : corners(box)) balls.push_back({corner, 0});
  return balls;
}
inline std::vector<Sphere3d> balls_in(const Aabb3d& box) {
  std::vector<Sphere3d> corners;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) corners.push_back({{x, y, z}, 0});
  return corners;
}

inline std::vector<Sphere3d> balls_in(const Meshd& mesh) {
  std::vector<Sphere3d> vertices;
  for (const Point3d& p : mesh.vertices) vertices.push_back({p, 0});
  return vertices;
}

inline Contact with_ball(const Sphere3d& ball, const Sphere3d& other) { return robust::sphere_sphere(ball, other); }
inline Contact with_ball(const Sphere3d& ball, const Capsule3d& other) { return robust::sphere_capsule(ball, other); }
inline Contact with_ball(const Sphere3d& ball, const Triangle3d& other) { return robust::sphere_triangle(ball, other); }
inline Contact with_ball(const Sphere3d& ball, const Obb3d& other) { return robust::sphere_obb(ball, other); }
inline Contact with_ball(const Sphere3d& ball, const Aabb3d& other) { return robust::sphere_aabb(ball, other); }
inline Contact with_ball(const Sphere3d& ball, const Meshd& other) { return robust::sphere_convex(ball, other); }

inline bool flat(const auto&) { return false; }
inline bool flat(const Aabb3d& box) {
  return box.min.x == box.max.x || box.min.y == box.max.y || box.min.z == box.max.z;
}

template <class Ask, class A, class B>
bool same_if_rewritten(const Ask& ask, const A& a, const B& b) {
  const Contact contact = ask(std::tuple{a, b});
  for (const A& same : rewritten(a))
    if (ask(std::tuple{same, b}) != contact) return false;
  for (const B& same : rewritten(b))
    if (ask(std::tuple{a, same}) != contact) return false;
  if constexpr (requires { a.radius + b.radius; }) {
    std::tuple exchanged{a, b};
    std::swap(std::get<0>(exchanged).radius, std::get<1>(exchanged).radius);
    return ask(exchanged) == contact;
  }
  return true;
}

/// False if there is no greater radius.
template <class Solid>
bool grow(Solid& solid) {
  if constexpr (requires { solid.radius; }) {
    if (solid.radius == greatest) return false;
    solid.radius = catalogue::moved_by_ulps(solid.radius, 1);
  }
  return true;
}

template <class Ask, class A, class B>
bool keeps_contact_growing(const Ask& ask, A a, B b) {
  const Contact contact = ask(std::tuple{a, b});
  if (!grow(a) || !grow(b) || contact == Contact::disjoint) return true;
  return ask(std::tuple{a, b}) == (flat(a) || flat(b) ? Contact::touching : Contact::overlapping);
}

/// A part meets no more than the solid; a capsule of one point is the ball.
template <class Ask, class Solid, class Other>
bool meets_with_parts(const Ask& ask, const Solid& solid, const Other& other) {
  const Contact whole = ask(solid, other);
  for (const Sphere3d& ball : balls_in(solid)) {
    const Contact part = with_ball(ball, other);
    if (whole < part) return false;
    if constexpr (std::is_same_v<Solid, Capsule3d>)
      if (ask(Capsule3d{{ball.center, ball.center}, ball.radius}, other) != part) return false;
  }
  return true;
}

/// The promise of the contracts of capsules for solids that are disjoint: where the numbers of `places` make it
/// certain, the formula says so. `underflow`: in units of the least number.
template <class Truth, class Places>
bool is_apart_where_certain(const Truth& truth, Contact answer, const Places& places, int underflow, double radius) {
  Rational sizes;
  for (const double number : numbers_of(places)) sizes += abs(exact(number));
  const Rational e(5 * unit() * sizes + underflow * power_of_two(-1074)), r = exact(radius);
  return answer == Contact::disjoint || !certainly_apart(Rational(*truth.margin + r * r), e, r);
}

/// The same of a core and a convex mesh, by the contract of sphere_convex.
template <class Truth>
bool is_apart_from_mesh_where_certain(const Truth& truth, Contact answer, const Meshd& core, const Meshd& mesh,
                                      double radius) {
  if (truth.answer != Contact::disjoint || !below_2_to_200(core) || !below_2_to_200(mesh)) return true;
  if (!finite(radius * radius) || reference::nearest_simplex(core, mesh).pairs.size() == 4) return true;
  const Rational r = exact(radius), e(off_by(core) + off_by(mesh));
  return answer == Contact::disjoint || !certainly_apart(Rational(*truth.margin + r * r), e, r);
}

/// A point only touches the solid that it is in, and a ball around such a point overlaps it.
template <class Ask, class Solid>
bool center_tells(const Ask& ask, const Sphere3d& ball, const Solid& solid, Location center) {
  const bool in = center != Location::outside;
  if (ask(std::tuple{Sphere3d{ball.center, 0}, solid}) != (in ? Contact::touching : Contact::disjoint)) return false;
  return !in || ask(std::tuple{ball, solid}) == (ball.radius == 0 ? Contact::touching : Contact::overlapping);
}

/// Balls beside a cube from -2 to 2, worked by hand.
void balls_beside(const auto& cube, const auto& worked) {
  worked({{{5, 6, 0}, 4}, cube}, Contact::disjoint, 9);      // beyond an edge by (3, 4): 25 - 16
  worked({{{5, 6, 0}, 5}, cube}, Contact::touching, 0);      // 25 - 25
  worked({{{5, 6, 0}, 6}, cube}, Contact::overlapping, 11);  // 36 - 25
  worked({{{3, 4, 4}, 3}, cube}, Contact::touching, 0);      // beyond a corner by (1, 2, 2)
  worked({{{1, -5, 2}, 3}, cube}, Contact::touching, 0);     // beyond a face
  worked({{{1, 1, 0}, 1}, cube}, Contact::overlapping, 1);   // within: 1 - 0
  worked({{{0, 0, 0}, 9}, cube}, Contact::overlapping, 81);  // the cube within the ball
}

/// ROUND_LAWS("sphere_obb") is three test cases, in the types of the file's `Row`.
#define ROUND_LAWS(operation)                                                                    \
  LAW(operation ": a solid that is written in another way has the same contact", a, b) {         \
    return same_if_rewritten(ask, a, b);                                                         \
  }                                                                                              \
  LAW(operation ": solids that grow never lose contact, and those that touched overlap", a, b) { \
    return keeps_contact_growing(ask, a, b);                                                     \
  }                                                                                              \
  ROUND_LAW_OF_PARTS(operation)
#define ROUND_LAW_OF_PARTS(operation)                                                                             \
  ROBUST_LAW(operation ": a part of a solid meets no more than it, and a capsule of one point is a ball", a, b) { \
    const auto in_order = [&ask](const auto& x, const auto& y) { return ask(Row::Question{x, y}); };              \
    const auto reversed = [&ask](const auto& y, const auto& x) { return ask(Row::Question{x, y}); };              \
    return meets_with_parts(in_order, a, b) && meets_with_parts(reversed, b, a);                                  \
  }

}  // namespace touchstone::proptests
