// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/common_dimension.h"

#include <optional>

#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using Row = Program::Row;
using IntegerPoints = std::vector<IntegerPoint>;

IntegerPoints corners_of(const Triangle3<Integer>& t) { return {t.a, t.b, t.c}; }

/// The number of independent vectors.
int rank(const std::vector<IntegerVector>& vectors) {
  IntegerVector first{0, 0, 0}, normal{0, 0, 0};
  for (const IntegerVector& v : vectors)
    if (zero(first)) first = v;
  if (zero(first)) return 0;
  for (const IntegerVector& v : vectors)
    if (zero(normal)) normal = cross(first, v);
  if (zero(normal)) return 1;
  for (const IntegerVector& v : vectors)
    if (sgn(dot(normal, v)) != 0) return 3;
  return 2;
}

std::vector<IntegerVector> displacements(const IntegerPoints& corners) {
  std::vector<IntegerVector> found;
  for (const IntegerPoint& p : corners) found.push_back(p - corners.front());
  return found;
}

IntegerPoints in_plane(const IntegerPoints& corners, const WitnessPlane& plane) {
  IntegerPoints kept;
  for (const IntegerPoint& p : corners)
    if (dot(plane.normal, p - IntegerPoint{0, 0, 0}) == plane.offset) kept.push_back(p);
  return kept;
}

/// The six weights; rows: the sums of each triangle's, and the three coordinates of the point.
Program weights_of_both(const IntegerPoints& a, const IntegerPoints& b) {
  Program program(6, std::vector<Row>(5, Row::equal));
  int variable = 0;
  const auto add = [&](const IntegerPoint& p, int sum, int sign) {
    program.set_coefficient(sum, variable, 1);
    program.set_coefficient(2, variable, Integer(sign * p.x)),
        program.set_coefficient(3, variable, Integer(sign * p.y)),
        program.set_coefficient(4, variable, Integer(sign * p.z));
    ++variable;
  };
  for (const IntegerPoint& p : a) add(p, 0, 1);
  for (const IntegerPoint& p : b) add(p, 1, -1);
  program.set_right_side(0, 1), program.set_right_side(1, 1);
  return program;
}

PointOfBoth point_at(const Program& program) {
  const auto weight = [&program](int i) { return quotient(program.numerator(i), program.denominator()); };
  return {{weight(0), weight(1), weight(2)}, {weight(3), weight(4), weight(5)}};
}

/// The common point at the program's current vertex, times the denominator.
struct Scaled {
  IntegerPoint at;
  Integer denominator;
};
Scaled scaled_at(const Program& program, const IntegerPoints& a) {
  IntegerPoint sum{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Integer weight = program.numerator(i);
    sum = sum + weight * (a[static_cast<std::size_t>(i)] - IntegerPoint{0, 0, 0});
  }
  return {sum, program.denominator()};
}
IntegerVector displacement(const Scaled& p, const Scaled& q) {
  const IntegerPoint origin{0, 0, 0};
  return p.denominator * (q.at - origin) - q.denominator * (p.at - origin);
}

}  // namespace

CommonDimension::CommonDimension(const Triangle3<Integer>& a, const Triangle3<Integer>& b) : dimension(-1) {
  IntegerPoints of_a = corners_of(a), of_b = corners_of(b);
  while (!of_a.empty() && !of_b.empty()) {
    auto plane = plane_between(of_a, of_b);
    if (!plane) {
      const std::vector<IntegerVector> on_a = displacements(of_a), on_b = displacements(of_b);
      std::vector<IntegerVector> both = on_a;
      both.insert(both.end(), on_b.begin(), on_b.end());
      dimension = rank(on_a) + rank(on_b) - rank(both);
      return;
    }
    of_a = in_plane(of_a, *plane), of_b = in_plane(of_b, *plane);
    planes.push_back(std::move(*plane));
  }
}

std::vector<PointOfBoth> points_of_both(const Triangle3<Integer>& a, const Triangle3<Integer>& b, int dimension) {
  const IntegerPoints of_a = corners_of(a);
  Program program = weights_of_both(of_a, corners_of(b));
  program.feasible();
  std::vector<PointOfBoth> found{point_at(program)};
  const Scaled first = scaled_at(program, of_a);
  IntegerVector along{0, 0, 0};
  /// Goes to the least of direction . p, and takes the point if it is not in the space of the others.
  const auto look = [&](const IntegerVector& direction) {
    std::vector<Integer> cost;
    for (const IntegerPoint& p : of_a) cost.push_back(dot(direction, p - IntegerPoint{0, 0, 0}));
    cost.resize(6);
    program.minimise(cost);
    const IntegerVector there = displacement(first, scaled_at(program, of_a));
    if (found.size() == 1 ? zero(there) : zero(cross(along, there))) return;
    if (found.size() == 1) along = there;
    found.push_back(point_at(program));
  };
  const auto wanted = static_cast<std::size_t>(dimension) + 1;
  for (const IntegerVector& axis : {IntegerVector{1, 0, 0}, IntegerVector{0, 1, 0}, IntegerVector{0, 0, 1}})
    for (const int sign : {1, -1})
      if (found.size() < 2 && found.size() < wanted) look(Integer(sign) * axis);
  if (wanted < 3) return found;
  const IntegerVector across = cross(cross(a.b - a.a, a.c - a.a), along);
  for (const int sign : {1, -1})
    if (found.size() < wanted) look(Integer(sign) * across);
  return found;
}

}  // namespace touchstone::oracle
