// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/plane_between.h"

#include <array>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using Row = Program::Row;
using IntegerPoints = std::vector<IntegerPoint>;

}  // namespace

/// normal . p - offset <= 0 at all of a, >= 0 at all of b, and the sum of all sizes is 1; normal and offset as
/// differences of numbers that are not negative.
std::optional<WitnessPlane> plane_between(const IntegerPoints& a, const IntegerPoints& b) {
  std::vector<Row> rows(a.size() + b.size(), Row::at_most);
  rows.push_back(Row::equal);
  const int last = static_cast<int>(rows.size()) - 1;
  Program program(8, rows);
  std::array<Integer, 4> sum;
  int row = 0;
  const auto add = [&](const IntegerPoint& p, int sign) {
    const std::array<Integer, 4> column{Integer(sign * p.x), Integer(sign * p.y), Integer(sign * p.z), Integer(-sign)};
    for (int i = 0; i < 4; ++i) {
      program.set_coefficient(row, 2 * i, column[i]), program.set_coefficient(row, 2 * i + 1, Integer(-column[i]));
      sum[i] -= column[i];
    }
    ++row;
  };
  for (const IntegerPoint& p : a) add(p, 1);
  for (const IntegerPoint& p : b) add(p, -1);
  for (int i = 0; i < 4; ++i)
    program.set_coefficient(last, 2 * i, sum[i]), program.set_coefficient(last, 2 * i + 1, Integer(-sum[i]));
  program.set_right_side(last, 1);
  if (!program.feasible()) return std::nullopt;
  const auto number = [&program](int i) { return Integer(program.numerator(2 * i) - program.numerator(2 * i + 1)); };
  return WitnessPlane::of({number(0), number(1), number(2)}, Rational(number(3)));
}

/// No point is a weighted mean of both, weights adding up to 1 for each. In the Farkas vector y of that program
/// y[0] + n . p >= 0 at all of a, y[1] - n . p >= 0 at all of b, and y[0] + y[1] < 0.
std::optional<WitnessPlane> plane_apart(const IntegerPoints& a, const IntegerPoints& b) {
  Program program(static_cast<int>(a.size() + b.size()), std::vector<Row>(5, Row::equal));
  int variable = 0;
  const auto add = [&](const IntegerPoint& p, int sum, int sign) {
    program.set_coefficient(sum, variable, 1);
    program.set_coefficient(2, variable, Integer(sign * p.x));
    program.set_coefficient(3, variable, Integer(sign * p.y));
    program.set_coefficient(4, variable++, Integer(sign * p.z));
  };
  for (const IntegerPoint& p : a) add(p, 0, 1);
  for (const IntegerPoint& p : b) add(p, 1, -1);
  program.set_right_side(0, 1), program.set_right_side(1, 1);
  if (program.feasible()) return std::nullopt;
  const std::vector<Integer>& y = program.farkas();
  return WitnessPlane::of({y[2], y[3], y[4]}, quotient(Integer(y[1] - y[0]), Integer(2)));
}

}  // namespace touchstone::oracle
