// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/zonotope.h"

#include <algorithm>
#include <array>
#include <optional>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

/// Divides numbers, not all of them 0, by the greatest power of two that they share: the result is shorter.
void shorten(const std::vector<Integer*>& numbers) {
  mp_bitcnt_t shared = ~mp_bitcnt_t{0};
  for (const Integer* n : numbers)
    if (sgn(*n) != 0) shared = std::min(shared, mpz_scan1(n->get_mpz_t(), 0));
  for (Integer* n : numbers) mpz_tdiv_q_2exp(n->get_mpz_t(), n->get_mpz_t(), shared);
}

/// One coordinate: of the first point, then of every edge, then of the displacement from each further point to it.
using Equation = std::vector<Integer>;

Int128 number(const Integer& n, Int128) { return n.get_si(); }
const Integer& number(const Integer& n, const Integer&) { return n; }

/// With s_i = r_i + growth: sum s_i e_i - growth sum e_i + sum w_j (p_0 - p_j) = p_0, 0 <= s_i <= 2 growth, w_j >= 0,
/// sum w_j <= 1.
template <class Value>
Zonotope::Held solved(const std::array<Equation, 3>& equations, int count) {
  using Program = LinearProgram<Value>;
  const int all = static_cast<int>(equations[0].size());  // the edges, the growth and the further points
  std::vector<typename Program::Row> rows(3, Program::Row::equal);
  rows.insert(rows.end(), static_cast<std::size_t>(count), Program::Row::at_most);
  if (all > count + 1) rows.push_back(Program::Row::at_most);
  Program program(all, rows);
  for (int row = 0; row < 3; ++row) {
    const Equation& equation = equations[static_cast<std::size_t>(row)];
    Value sum(0);
    for (int i = 0; i < count; ++i) {
      const Value coordinate = number(equation[static_cast<std::size_t>(i + 1)], Value());
      program.set_coefficient(row, i, coordinate);
      sum += coordinate;
    }
    program.set_coefficient(row, count, Value(-sum));
    for (int j = count + 1; j < all; ++j)
      program.set_coefficient(row, j, number(equation[static_cast<std::size_t>(j)], Value()));
    program.set_right_side(row, number(equation[0], Value()));
  }
  for (int j = count + 1; j < all; ++j) program.set_coefficient(3 + count, j, Value(1));
  if (all > count + 1) program.set_right_side(3 + count, Value(1));
  for (int i = 0; i < count; ++i) {
    program.set_coefficient(3 + i, i, Value(1));
    program.set_coefficient(3 + i, count, Value(-2));
  }
  program.feasible();  // for a growth that is large enough
  std::vector<Value> cost(static_cast<std::size_t>(all));
  cost[static_cast<std::size_t>(count)] = 1;
  program.minimise(cost);
  const auto value = [&program](int variable) { return quotient(program.numerator(variable), program.denominator()); };
  Zonotope::Held found{value(count), {}, {Rational(1)}};
  for (int i = 0; i < count; ++i) found.coefficients.push_back(Rational(value(i) - found.growth));
  for (int j = count + 1; j < all; ++j) {
    found.weights.push_back(value(j));
    found.weights[0] -= found.weights.back();
  }
  return found;
}

}  // namespace

/// Six edges of 30 bits add up to less than 2^33, and three rows of such make minors below 3! 2^99; the other rows are
/// 1 in a column of their own and -2 in that of the growth, which makes a sum of less than 16 such minors.
Zonotope::Held Zonotope::held(const std::vector<Point3<Integer>>& points) const {
  std::array<Equation, 3> equations;
  std::size_t bits = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto coordinate = [axis](const auto& v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    Equation& equation = equations[axis];
    equation.push_back(coordinate(points[0]));
    for (const auto& edge : edges_) equation.push_back(coordinate(edge));
    for (std::size_t j = 1; j < points.size(); ++j) equation.push_back(coordinate(points[0] - points[j]));
    std::vector<Integer*> all;
    for (Integer& n : equation) all.push_back(&n);
    shorten(all);
    for (const Integer& n : equation) bits = std::max(bits, mpz_sizeinbase(n.get_mpz_t(), 2));
  }
  const int count = static_cast<int>(edges_.size());
  return bits <= 30 && count <= 6 && points.size() == 1 ? solved<Int128>(equations, count)
                                                        : solved<Integer>(equations, count);
}

Rational Zonotope::Support::squared_distance() const {
  return quotient(Integer(height * height), Integer(dot(normal, normal)));
}

Zonotope::Support Zonotope::deciding(const Vector3<Integer>& d) const {
  std::optional<Support> found;
  Integer found_square, found_length;  // of the height and of the normal, both squared
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    for (std::size_t j = i + 1; j < edges_.size(); ++j) {
      Support here{cross(edges_[i], edges_[j]), Integer(0)};
      auto& [normal, height] = here;
      if (zero(normal)) continue;
      shorten({&normal.x, &normal.y, &normal.z});
      height = dot(normal, d);
      if (sgn(height) < 0) normal = Integer(-1) * normal, height = -height;
      for (std::size_t k = 0; k < edges_.size(); ++k)
        if (k != i && k != j) height -= abs(dot(normal, edges_[k]));
      const bool beyond = sgn(height) > 0;
      if (found && sgn(found->height) > 0 && !beyond) continue;
      Integer square = height * height, length = dot(normal, normal);
      const bool first_beyond = beyond && !(found && sgn(found->height) > 0);
      if (found && !first_beyond && (square * found_length > found_square * length) != beyond) continue;
      found = std::move(here), found_square = std::move(square), found_length = std::move(length);
    }
  }
  return found.value();
}

}  // namespace touchstone::oracle
