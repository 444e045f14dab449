// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/linear_program.h"

#include <cstddef>
#include <utility>

namespace touchstone::oracle {
namespace {

/// (target * pivot - column * row) / divisor, which leaves no remainder.
void eliminate(Int128& target, Int128 pivot, Int128 column, Int128 row, const ExactDivision<Int128>& divide) {
  target = divide(product(target, pivot) - product(column, row));
}

void eliminate(Integer& target, const Integer& pivot, const Integer& column, const Integer& row,
               const ExactDivision<Integer>& divide) {
  mpz_mul(target.get_mpz_t(), target.get_mpz_t(), pivot.get_mpz_t());
  mpz_submul(target.get_mpz_t(), column.get_mpz_t(), row.get_mpz_t());
  divide.in_place(target);
}

void negate(Int128& value) { value = -value; }
void negate(Integer& value) { mpz_neg(value.get_mpz_t(), value.get_mpz_t()); }

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

template <class Value>
LinearProgram<Value>::LinearProgram(int variables, const std::vector<Row>& rows)
    : variables_(variables),
      columns_(variables + 1),
      rows_(rows),
      entries_(rows.size() * index(columns_), Value(0)),
      farkas_(),
      denominator_(1) {
  nonbasic_.reserve(index(variables)), basic_.reserve(rows.size());
  for (int j = 0; j < variables; ++j) nonbasic_.push_back(j);
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) basic_.push_back(variables + i);
}

template <class Value>
bool LinearProgram<Value>::fixed(int variable) const {
  return variable >= variables_ && rows_[index(variable - variables_)] == Row::equal;
}

template <class Value>
void LinearProgram<Value>::pivot(int row, int column) {
  const Value turn = entry(row, column);
  const ExactDivision<Value> divide(denominator_);
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    if (i == row) continue;
    const Value factor = entry(i, column);
    for (int j = 0; j < columns_; ++j) {
      if (j != column) eliminate(entry(i, j), turn, factor, entry(row, j), divide);
    }
    negate(entry(i, column));
  }
  entry(row, column) = denominator_;
  denominator_ = turn;
  if (sgn(denominator_) < 0) {
    negate(denominator_);
    for (Value& value : entries_) negate(value);
  }
  std::swap(basic_[index(row)], nonbasic_[index(column)]);
}

template <class Value>
void LinearProgram<Value>::prove_contradiction(int row) {
  farkas_.assign(rows_.size(), Value(0));
  const auto note = [&](int variable, const Value& multiplier) {
    if (variable >= variables_) farkas_[index(variable - variables_)] = multiplier;
  };
  note(basic_[index(row)], denominator_);
  for (int j = 0; j + 1 < columns_; ++j) note(nonbasic_[index(j)], entry(row, j));
  if (sgn(entry(row, columns_ - 1)) > 0) {  // an equation 0 = b: either sign of b contradicts
    for (Value& value : farkas_) negate(value);
  }
}

template <class Value>
bool LinearProgram<Value>::solve_equations() {
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    if (!fixed(basic_[index(i)])) continue;
    int column = 0;
    while (column + 1 < columns_ && (fixed(nonbasic_[index(column)]) || sgn(entry(i, column)) == 0)) ++column;
    if (column + 1 < columns_) {
      pivot(i, column);
    } else if (sgn(entry(i, columns_ - 1)) != 0) {
      prove_contradiction(i);
      return false;
    }
  }
  return true;
}

template <class Value>
bool LinearProgram<Value>::feasible() {
  if (!solve_equations()) return false;
  for (;;) {
    int row = -1, column = -1;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      if (sgn(entry(i, columns_ - 1)) >= 0) continue;
      if (row < 0 || basic_[index(i)] < basic_[index(row)]) row = i;
    }
    if (row < 0) return true;
    for (int j = 0; j + 1 < columns_; ++j) {
      const int variable = nonbasic_[index(j)];
      if (fixed(variable) || sgn(entry(row, j)) >= 0) continue;
      if (column < 0 || variable < nonbasic_[index(column)]) column = j;
    }
    if (column < 0) {
      prove_contradiction(row);
      return false;
    }
    pivot(row, column);
  }
}

template <class Value>
int LinearProgram<Value>::entering_column(const std::vector<Value>& cost) const {
  int column = -1;
  for (int j = 0; j + 1 < columns_; ++j) {
    const int variable = nonbasic_[index(j)];
    if (fixed(variable) || (column >= 0 && variable > nonbasic_[index(column)])) continue;
    Value slope(0);  // derivative of the objective by this variable, times the denominator
    if (variable < variables_) slope = cost[index(variable)] * denominator_;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      if (basic_[index(i)] < variables_) slope -= cost[index(basic_[index(i)])] * entry(i, j);
    }
    if (sgn(slope) < 0) column = j;
  }
  return column;
}

template <class Value>
int LinearProgram<Value>::leaving_row(int column) const {
  int row = -1;
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    if (sgn(entry(i, column)) <= 0) continue;
    if (row < 0) {
      row = i;
      continue;
    }
    const auto here = product(entry(i, columns_ - 1), entry(row, column));
    const auto best = product(entry(row, columns_ - 1), entry(i, column));
    const int order = here < best ? -1 : best < here ? 1 : 0;
    if (order < 0 || (order == 0 && basic_[index(i)] < basic_[index(row)])) row = i;
  }
  return row;
}

template <class Value>
bool LinearProgram<Value>::minimise(const std::vector<Value>& cost) {
  for (;;) {
    const int column = entering_column(cost);
    if (column < 0) return true;
    const int row = leaving_row(column);
    if (row < 0) return false;
    pivot(row, column);
  }
}

template <class Value>
Value LinearProgram<Value>::numerator(int variable) const {
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    if (basic_[index(i)] == variable) return entry(i, columns_ - 1);
  }
  return Value(0);
}

template class LinearProgram<Int128>;
template class LinearProgram<Integer>;

}  // namespace touchstone::oracle
