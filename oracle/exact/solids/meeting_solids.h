// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "oracle/exact/solids/convex_mesh.h"
#include "oracle/exact/systems/linear_program.h"

/// Decides whether the convex hulls of two lists of points, one of which moves, have a common point, by exact linear
/// programs.
namespace touchstone::oracle {

using Coordinates = std::array<Integer, 3>;

/// Vertices and velocity as integers times one positive unit.
struct Motion {
  std::vector<Coordinates> a, b;
  Coordinates velocity;
  Rational unit;
};

Motion motion(const ConvexMesh& a, const ConvexMesh& b, const std::array<Rational, 3>& velocity);

/// Variables: the weights of a, those of b, t, and more. Rows 0 to 2: the point of a, moved by t velocity, is that of
/// b; 3 and 4: the sums of the weights; 5: t <= 1; and more.
class Meeting {
 public:
  explicit Meeting(const Motion& m, int more_variables = 0, int more_rows = 0)
      : time_(static_cast<int>(m.a.size() + m.b.size())),
        variables_(time_ + 1 + more_variables),
        program_(variables_, rows(more_rows)) {
    int variable = 0;
    for (const Coordinates& p : m.a) set(variable, p, 1), program_.set_coefficient(3, variable++, Integer(1));
    for (const Coordinates& p : m.b) set(variable, p, -1), program_.set_coefficient(4, variable++, Integer(1));
    set(time_, m.velocity, 1), program_.set_coefficient(5, time_, Integer(1));
    for (const int row : {3, 4, 5}) program_.set_right_side(row, Integer(1));
  }

  /// The three coefficients in rows 0 to 2.
  void set(int variable, const Coordinates& p, int sign) {
    for (int k = 0; k < 3; ++k) program_.set_coefficient(k, variable, Integer(sign * p[static_cast<std::size_t>(k)]));
  }

  int time() const { return time_; }
  int more() const { return time_ + 1; }
  LinearProgram<Integer>& program() { return program_; }
  Rational value(int variable) const { return quotient(program_.numerator(variable), program_.denominator()); }

  /// The least value of a variable of a program that is feasible; with the cost -1 the greatest.
  Rational optimum(int variable, int cost = 1) {
    std::vector<Integer> costs(static_cast<std::size_t>(variables_), Integer(0));
    costs[static_cast<std::size_t>(variable)] = cost;
    program_.minimise(costs);
    return value(variable);
  }

 private:
  using Row = LinearProgram<Integer>::Row;

  static std::vector<Row> rows(int more) {
    std::vector<Row> rows(6 + static_cast<std::size_t>(more), Row::at_most);
    std::fill(rows.begin(), rows.begin() + 5, Row::equal);
    return rows;
  }

  int time_, variables_;
  LinearProgram<Integer> program_;
};

/// The distance by which a has to be moved, in the maximum norm and in units, until they meet; and, if they do, until
/// they no longer do.
Rational distance(const Motion& m);
Rational depth(const Motion& m);

}  // namespace touchstone::oracle
