// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {

/// Exact linear programming on integers: x >= 0 and, row by row, sum_j a_ij x_j = b_i or <= b_i.
///
/// Method: a dictionary of integers over one common denominator (every entry is a minor of the input, so each pivot
/// divides without remainder). The equations are solved first; then the dual simplex method for the zero objective
/// leads to a feasible vertex or to a row that proves there is none; then the primal simplex method to an optimum.
/// Bland's least-index rule in both, so no cycle.
///
/// Value: Integer (any input), or Int128 if the minors of (A b I), and cost . x over such, stay within 127 bits.
template <class Value>
class LinearProgram {
 public:
  enum class Row { equal, at_most };

  LinearProgram(int variables, const std::vector<Row>& rows);

  void set_coefficient(int row, int variable, const Value& value) { entry(row, variable) = value; }
  void set_right_side(int row, const Value& value) { entry(row, columns_ - 1) = value; }

  /// Looks for a feasible vertex. Afterwards numerator() describes it, or farkas() the contradiction.
  bool feasible();

  /// Moves from a feasible vertex to one where cost . x is least; returns false if it is unbounded.
  bool minimise(const std::vector<Value>& cost);

  /// Variable j is numerator(j) / denominator() at the vertex; the denominator is positive.
  Value numerator(int variable) const;
  const Value& denominator() const { return denominator_; }

  /// After feasible() was false: y, one number a row, with y_i >= 0 on the <= rows, sum_i y_i a_ij >= 0 for every
  /// variable j and sum_i y_i b_i < 0. No x >= 0 can satisfy that sum of the rows.
  const std::vector<Value>& farkas() const { return farkas_; }

 private:
  Value& entry(int row, int column) { return entries_[static_cast<std::size_t>(row * columns_ + column)]; }
  const Value& entry(int row, int column) const { return entries_[static_cast<std::size_t>(row * columns_ + column)]; }
  bool fixed(int variable) const;
  bool solve_equations();
  void prove_contradiction(int row);
  int entering_column(const std::vector<Value>& cost) const;
  int leaving_row(int column) const;
  void pivot(int row, int column);

  int variables_, columns_;  // the last column is the right side
  std::vector<Row> rows_;    // variable variables_ + i is the slack of row i: 0, or >= 0
  std::vector<int> basic_, nonbasic_;
  std::vector<Value> entries_;  // basic_i = (entry(i, last) - sum_j entry(i, j) nonbasic_j) / denominator_
  std::vector<Value> farkas_;
  Value denominator_;
};

extern template class LinearProgram<Int128>;
extern template class LinearProgram<Integer>;

}  // namespace touchstone::oracle
