// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/obb_passage.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;

/// On one unit: the half axes, the line's way, and its start as seen from the box's center.
struct InUnits {
  CommonScale<Rational, 15> scale;
  std::array<IntegerVector, 3> half_axes;
  IntegerVector way, start;
  bool ends;

  InUnits(const Line& line, const Obb3<Rational>& box) : scale(in_a_row(line, box)), ends(line.ends) {
    for (std::size_t k = 0; k < 3; ++k) half_axes[k] = at(3 * k);
    way = at(9), start = at(12);
  }

 private:
  IntegerVector at(std::size_t i) const { return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)}; }
  static std::array<Rational, 15> in_a_row(const Line& line, const Obb3<Rational>& box) {
    const auto& [u, v, w] = box.half_axes;
    const auto &p = line.from, &d = line.displacement;
    const Point3<Rational>& c = box.center;
    return {u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, d[0], d[1], d[2], p[0] - c.x, p[1] - c.y, p[2] - c.z};
  }
};

/// With s_k = r_k + 1: sum s_k e_k - t way = start + sum e_k, s_k <= 2; t <= 1 if the line ends.
Program program_of(const InUnits& n) {
  std::vector<Program::Row> rows(3, Program::Row::equal);
  rows.insert(rows.end(), n.ends ? 4 : 3, Program::Row::at_most);
  Program program(4, rows);
  static constexpr std::array<Integer IntegerVector::*, 3> coordinates{&IntegerVector::x, &IntegerVector::y,
                                                                       &IntegerVector::z};
  for (int row = 0; row < 3; ++row) {
    const auto coordinate = coordinates[static_cast<std::size_t>(row)];
    Integer sum = n.start.*coordinate;
    program.set_coefficient(row, 0, Integer(-(n.way.*coordinate)));
    for (int k = 0; k < 3; ++k) {
      const Integer& of_edge = n.half_axes[static_cast<std::size_t>(k)].*coordinate;
      program.set_coefficient(row, 1 + k, of_edge);
      sum += of_edge;
    }
    program.set_right_side(row, sum);
  }
  for (int k = 0; k < 3; ++k) program.set_coefficient(3 + k, 1 + k, 1), program.set_right_side(3 + k, 2);
  if (n.ends) program.set_coefficient(6, 0, 1), program.set_right_side(6, 1);
  return program;
}

/// Returns how far 0 is from the faces' planes of the solid of displacements: from the farthest of those that it is
/// beyond, or from the nearest of all. In the maximum norm that is the height over the sum of the magnitudes of the
/// normal. A ray's end is infinitely far: along a normal that leads back there is no such plane.
Rational distance_to_change(const InUnits& n) {
  const auto& [u, v, w] = n.half_axes;
  const std::array<std::pair<const IntegerVector*, const IntegerVector*>, 6> edges{
      {{&u, &v}, {&v, &w}, {&w, &u}, {&u, &n.way}, {&v, &n.way}, {&w, &n.way}}};
  std::optional<Rational> highest;
  for (const auto& [one, other] : edges) {
    const IntegerVector normal = cross(*one, *other);
    if (zero(normal)) continue;
    const Integer length = abs(normal.x) + abs(normal.y) + abs(normal.z), along = dot(normal, n.way),
                  height = dot(normal, n.start);
    Integer reach;
    for (const IntegerVector& half_axis : n.half_axes) reach += abs(dot(normal, half_axis));
    for (const int side : {1, -1}) {
      const Integer climb(side * along);
      if (!n.ends && sgn(climb) < 0) continue;
      const Rational beyond = quotient(Integer(side * height + std::min(climb, Integer(0)) - reach), length);
      highest = highest ? std::max(*highest, beyond) : beyond;
    }
  }
  return n.scale.actual(Rational(abs(highest.value())), 1);
}

}  // namespace

/// Farkas' sum of the equations, reversed, is a normal: the other rows add its reach, and how far a segment leads back.
Truth<Passage<Rational>> passage_of_parallelepiped(const Line& line, const Obb3<Rational>& box) {
  const InUnits n(line, box);
  Program program = program_of(n);
  Truth<Passage<Rational>> truth{{PassageRelation::none, {}, {}}, distance_to_change(n)};
  if (!program.feasible()) {
    std::vector<Rational> normal;
    for (std::size_t k = 0; k < 3; ++k) normal.emplace_back(Integer(-program.farkas()[k]));
    truth.certificate = [normal = std::move(normal)] { return Certificate{"separating_plane", {{"normal", normal}}}; };
    return truth;
  }
  const auto optimum = [&program](int cost) {
    program.minimise({Integer(cost), 0, 0, 0});
    return quotient(program.numerator(0), program.denominator());
  };
  const Rational first = optimum(1);
  truth.answer = {PassageRelation::hit, first, zero(n.way) ? first : optimum(-1)};
  truth.certificate = [] { return Certificate{"passage", {}}; };
  return truth;
}

}  // namespace touchstone::oracle
