// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/triangles.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using Segment = Segment3<Integer>;
using Triangle = Triangle3<Integer>;

constexpr int at_b = 1, corners = 2;  // variables: the weight of segment.b is t

Rational value_of(const Program& program, int variable) {
  return quotient(program.numerator(variable), program.denominator());
}

CommonPoint common_point(const Program& program) {
  return {value_of(program, at_b),
          {value_of(program, corners), value_of(program, corners + 1), value_of(program, corners + 2)}};
}

void set_column(Program& program, int first_row, int variable, const Integer& x, const Integer& y, const Integer& z) {
  program.set_coefficient(first_row, variable, x);
  program.set_coefficient(first_row + 1, variable, y);
  program.set_coefficient(first_row + 2, variable, z);
}

Integer square(const IntegerVector& v) { return dot(v, v); }

Rational squared_distance(const IntegerPoint& p, const Segment& s) {
  const IntegerVector along = s.b - s.a, from = p - s.a;
  const Integer length = square(along), foot = dot(from, along);
  if (sgn(foot) <= 0) return Rational(square(from));
  if (foot >= length) return Rational(square(p - s.b));
  return quotient(square(cross(along, from)), length);
}

/// From the nearer of their ends, or along the common perpendicular if its feet are within both.
Rational squared_distance(const Segment& s, const Segment& r) {
  const Rational ends = std::min(
      {squared_distance(s.a, r), squared_distance(s.b, r), squared_distance(r.a, s), squared_distance(r.b, s)});
  const IntegerVector u = s.b - s.a, v = r.b - r.a, w = r.a - s.a, normal = cross(u, v);
  const Integer whole = square(normal), on_s = dot(cross(w, v), normal), on_r = dot(cross(w, u), normal);
  const auto within = [&whole](const Integer& foot) { return sgn(foot) >= 0 && foot <= whole; };
  if (sgn(whole) == 0 || !within(on_s) || !within(on_r)) return ends;
  const Integer height = dot(w, normal);
  return std::min(ends, quotient(Integer(height * height), whole));
}

/// The squared height if the foot of the perpendicular is in the triangle.
std::optional<Rational> squared_height(const IntegerPoint& p, const Triangle& t) {
  const IntegerVector normal = cross(t.b - t.a, t.c - t.a);
  if (zero(normal)) return std::nullopt;
  const auto beyond = [&](const IntegerPoint& from, const IntegerPoint& to) {
    return sgn(dot(cross(normal, to - from), p - from)) < 0;
  };
  if (beyond(t.a, t.b) || beyond(t.b, t.c) || beyond(t.c, t.a)) return std::nullopt;
  const Integer height = dot(normal, p - t.a);
  return quotient(Integer(height * height), square(normal));
}

}  // namespace

WitnessPlane WitnessPlane::of(const IntegerVector& normal, const Rational& offset) {
  if (zero(normal)) return {normal, offset};
  const Integer factor = gcd(gcd(normal.x, normal.y), normal.z);
  return {{Integer(normal.x / factor), Integer(normal.y / factor), Integer(normal.z / factor)},
          Rational(offset / Rational(factor))};
}

CommonPart::CommonPart(const Segment& segment, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  Program program(5, std::vector<Program::Row>(5, Program::Row::equal));
  for (const int end : {0, at_b}) program.set_coefficient(0, end, 1);
  for (const int corner : {0, 1, 2}) program.set_coefficient(1, corners + corner, 1);
  program.set_right_side(0, 1), program.set_right_side(1, 1);
  set_column(program, 2, 0, segment.a.x, segment.a.y, segment.a.z);
  set_column(program, 2, at_b, segment.b.x, segment.b.y, segment.b.z);
  int variable = corners;
  for (const IntegerPoint* corner : {&a, &b, &c})
    set_column(program, 2, variable++, -corner->x, -corner->y, -corner->z);
  any = program.feasible();
  if (!any) {
    // y[0] + n . p >= 0 at both ends, y[1] - n . p >= 0 at all corners, y[0] + y[1] < 0.
    const std::vector<Integer>& y = program.farkas();
    between = WitnessPlane::of({y[2], y[3], y[4]}, quotient(Integer(y[1] - y[0]), Integer(2)));
    return;
  }
  program.minimise({0, 1, 0, 0, 0});
  first = common_point(program);
  program.minimise({0, -1, 0, 0, 0});
  last = common_point(program);
}

Point3<Rational> point_at(const Segment& segment, const Rational& t) {
  const IntegerVector along = segment.b - segment.a;
  return {Rational(segment.a.x + t * along.x), Rational(segment.a.y + t * along.y),
          Rational(segment.a.z + t * along.z)};
}

WitnessPlane plane_at_first(const Segment& segment, const Triangle& triangle, const Rational& t) {
  // normal . (corner - x) <= 0 and normal . (segment.a - x) > 0, x the point: times the denominator of t, in integers;
  // the normal as a difference of two that are not negative.
  const Integer &n = t.get_num(), &d = t.get_den();
  const IntegerVector along = segment.b - segment.a;
  const auto from_x = [&](const IntegerPoint& p) {
    const IntegerVector to = p - segment.a;
    return IntegerVector{Integer(d * to.x - n * along.x), Integer(d * to.y - n * along.y),
                         Integer(d * to.z - n * along.z)};
  };
  using Row = Program::Row;
  Program program(6, {Row::at_most, Row::at_most, Row::at_most, Row::equal});
  int row = 0;
  for (const IntegerPoint* p : {&triangle.a, &triangle.b, &triangle.c, &segment.a}) {
    const IntegerVector v = from_x(*p);
    int variable = 0;
    for (const Integer& coordinate : {v.x, v.y, v.z}) {
      program.set_coefficient(row, variable++, coordinate);
      program.set_coefficient(row, variable++, Integer(-coordinate));
    }
    ++row;
  }
  program.set_right_side(3, 1);
  program.feasible();
  const auto coordinate = [&program](int i) {
    return Integer(program.numerator(2 * i) - program.numerator(2 * i + 1));
  };
  const IntegerVector normal{coordinate(0), coordinate(1), coordinate(2)};
  const Point3<Rational> x = point_at(segment, t);
  return WitnessPlane::of(normal, Rational(normal.x * x.x + normal.y * x.y + normal.z * x.z));
}

Rational squared_distance_to_touch(const Segment& segment, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  Rational least = std::min(
      {squared_distance(segment, {a, b}), squared_distance(segment, {b, c}), squared_distance(segment, {c, a})});
  for (const IntegerPoint* end : {&segment.a, &segment.b})
    if (const auto height = squared_height(*end, triangle)) least = std::min(least, *height);
  return least;
}

}  // namespace touchstone::oracle
