// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/triangle_aabb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using TriangleAabbPoint = std::array<Integer, 3>;

/// In units of the scale.
struct IntegerInput {
  std::array<TriangleAabbPoint, 3> triangle;
  TriangleAabbPoint min, max;
};

/// The point of the triangle that is farthest within all six faces, and how far.
struct Deepest {
  std::array<Rational, 3> weights;
  Rational depth;
};

/// With the weights v and w of the second and third corner, and s for the depth beyond that of the first corner: v + w
/// <= 1 and, face by face, s <= height + v rise + w rise, of which the first corner's depth is taken.
Deepest deepest(const IntegerInput& q) {
  using Program = LinearProgram<Integer>;
  Program program(3, std::vector<Program::Row>(7, Program::Row::at_most));
  std::array<Integer, 6> height;
  const auto& [a, b, c] = q.triangle;
  for (int face = 0; face < 6; ++face) {
    const auto k = static_cast<std::size_t>(face / 2);
    const bool lower = face % 2 == 0;
    height[static_cast<std::size_t>(face)] = lower ? Integer(a[k] - q.min[k]) : Integer(q.max[k] - a[k]);
    program.set_coefficient(face, 0, lower ? Integer(a[k] - b[k]) : Integer(b[k] - a[k]));
    program.set_coefficient(face, 1, lower ? Integer(a[k] - c[k]) : Integer(c[k] - a[k]));
    program.set_coefficient(face, 2, 1);
  }
  const Integer first = *std::min_element(height.begin(), height.end());
  for (int face = 0; face < 6; ++face)
    program.set_right_side(face, Integer(height[static_cast<std::size_t>(face)] - first));
  program.set_coefficient(6, 0, 1), program.set_coefficient(6, 1, 1), program.set_right_side(6, 1);
  program.feasible();  // at the first corner
  program.minimise({0, 0, -1});
  const auto value = [&program](int i) { return quotient(program.numerator(i), program.denominator()); };
  const Rational v = value(0), w = value(1);
  return {{Rational(1 - v - w), v, w}, Rational(first + value(2))};
}

std::vector<Point3<Integer>> corners_of_triangle(const IntegerInput& q) {
  std::vector<Point3<Integer>> all;
  for (const TriangleAabbPoint& p : q.triangle) all.push_back({p[0], p[1], p[2]});
  return all;
}
std::vector<Point3<Integer>> corners_of_box(const IntegerInput& q) {
  std::vector<Point3<Integer>> all;
  for (const TriangleAabbPoint* x : {&q.min, &q.max})
    for (const TriangleAabbPoint* y : {&q.min, &q.max})
      for (const TriangleAabbPoint* z : {&q.min, &q.max}) all.push_back({(*x)[0], (*y)[1], (*z)[2]});
  return all;
}

template <class Scale>
Certificate certificate_triangle_aabb(const Scale& scale, const IntegerInput& q, const Deepest& found) {
  const std::vector<Point3<Integer>> triangle = corners_of_triangle(q), box = corners_of_box(q);
  const auto facts_of = [&scale](const WitnessPlane& plane) -> Certificate {
    const auto& n = plane.normal;
    return {"separating_plane",
            {{"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}}, {"offset", {scale.actual(plane.offset, 1)}}}};
  };
  if (sgn(found.depth) < 0) return facts_of(*plane_apart(box, triangle));
  const std::vector<Rational> weights(found.weights.begin(), found.weights.end());
  if (sgn(found.depth) > 0) return {"common_interior_point", {{"weights", weights}}};
  for (std::size_t k = 0; k < 3; ++k)
    if (q.min[k] == q.max[k])
      return {"flat_axis", {{"weights", weights}, {"axis", {Rational(static_cast<std::uint64_t>(k))}}}};
  Certificate touching = facts_of(*plane_between(triangle, box));
  touching.kind = "supporting_plane", touching.facts.emplace_back("weights", weights);
  return touching;
}

template <class Number>
Truth<Contact> truth_triangle_aabb(const Triangle3<Number>& triangle, const Aabb3<Number>& aabb) {
  validation::validate_all("triangle", triangle, "aabb", aabb);
  const auto& [a, b, c] = triangle;
  const auto& [min, max] = aabb;
  const CommonScale<Number, 15> scale(
      {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, min.x, min.y, min.z, max.x, max.y, max.z});
  const auto point = [&scale](std::size_t i) {
    return TriangleAabbPoint{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  const IntegerInput integers{{point(0), point(3), point(6)}, point(9), point(12)};
  const Deepest found = deepest(integers);
  const int side = sgn(found.depth);
  return {side > 0   ? Contact::overlapping
          : side < 0 ? Contact::disjoint
                     : Contact::touching,
          scale.actual(Rational(abs(found.depth)), 1),
          [=] { return certificate_triangle_aabb(scale, integers, found); }};
}

}  // namespace

template <Exact Number>
Truth<Contact> triangle_aabb(const Triangle3<Number>& triangle, const Aabb3<Number>& aabb) {
  return truth_triangle_aabb(triangle, aabb);
}
template Truth<Contact> triangle_aabb(const Triangle3d&, const Aabb3d&);
template Truth<Contact> triangle_aabb(const Triangle3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
