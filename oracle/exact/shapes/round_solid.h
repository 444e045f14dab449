// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {

/// A round convex solid: all that is no farther from its core than a radius.
struct RoundSolid {
  Hull core;
  /// The radius. A core that counts as a solid by itself is not grown, and has none: a box, and a triangle in the
  /// contracts of what meets it.
  std::vector<Rational> radii;
  bool box = false;                 ///< the core is a parallelepiped, its corners in the order of corners_of
  std::optional<Rational> width{};  ///< of a core along the axes: the least; if it is 0 there is no interior
};

/// center + r u + s v + t w, where r, s and t are 1 in corner number i if its bits 0, 1 and 2 are, and otherwise -1.
Hull corners_of(const Obb3<Rational>& box);
/// The coefficients of the half axes that weights of these corners make.
std::vector<Rational> coefficients_of(const std::vector<Rational>& weights);

template <class Number>
RoundSolid round_solid(const Sphere3<Number>& sphere) {
  return {{exact(sphere.center)}, {exact(sphere.radius)}};
}
template <class Number>
RoundSolid round_solid(const Capsule3<Number>& capsule) {
  return {{exact(capsule.segment.a), exact(capsule.segment.b)}, {exact(capsule.radius)}};
}
template <class Number>
RoundSolid round_solid(const Triangle3<Number>& triangle) {
  return {{exact(triangle.a), exact(triangle.b), exact(triangle.c)}, {}};
}
template <class Number>
RoundSolid round_solid(const Obb3<Number>& box) {
  const auto along = [](const Vector3<Number>& v) { return Vector3<Rational>{exact(v.x), exact(v.y), exact(v.z)}; };
  const auto& [u, v, w] = box.half_axes;
  return {corners_of({exact(box.center), {along(u), along(v), along(w)}}), {}, true};
}

template <class Number>
RoundSolid round_solid(const Aabb3<Number>& box) {
  const Point3<Rational> low = exact(box.min), high = exact(box.max);
  RoundSolid solid{
      {}, {}, false, std::min({Rational(high.x - low.x), Rational(high.y - low.y), Rational(high.z - low.z)})};
  for (unsigned i = 0; i < 8; ++i)
    solid.core.push_back(
        {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  return solid;
}

/// The contact of two round convex solids. They have a common point exactly if the distance of the cores is at most the
/// sum of the radii, and a common interior point, or an interior point of the only solid in a triangle, exactly if it
/// is less, no radius is 0, and no box is flat.
///
/// Margin: in squares, the difference of the distance and that sum; if they meet, and a radius becomes 0, the decrease
/// of the sum, if that is less; and the least width of a box along the axes.
///
/// Certificate, with a nearest point of each core as facts: disjoint: "nearest_points". touching: "tangent", or
/// "no_interior", if a radius is 0, or a box flat, and they are nearer. overlapping: "near_points". The point of a box
/// is given by its coordinates or the coefficients of its half axes, that of another core by the weights of its points,
/// that of a single point not at all.
Truth<Contact> contact_of(const RoundSolid& a, const RoundSolid& b);
/// The same from nearest points of the cores that are known.
Truth<Contact> contact_of(const RoundSolid& a, const RoundSolid& b, const NearestPair& nearest);

template <class Shape>
void validate_round(const std::string& field, const Shape& shape) {
  validation::validate(field, shape);
}
template <class Number>
void validate_round(const std::string& field, const Obb3<Number>& box) {
  validate_parallelepiped(field, box);
}

/// The same of shapes in their fields; refuses invalid input.
template <class A, class B>
Truth<Contact> contact_of_round(const std::string& field_of_a, const A& a, const std::string& field_of_b, const B& b) {
  validation::validate_numbers(field_of_a, a), validation::validate_numbers(field_of_b, b);
  validate_round(field_of_a, a), validate_round(field_of_b, b);
  return contact_of(round_solid(a), round_solid(b));
}

}  // namespace touchstone::oracle
