// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/linear_program.h"

#include <cstdint>
#include <type_traits>

#include "proptests/catch.h"

namespace {

using namespace touchstone::oracle;
using touchstone::Int128;

/// SplitMix64: the same small programs on every machine.
struct Stream {
  std::uint64_t state;
  std::int64_t below(std::int64_t n) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return static_cast<std::int64_t>((z ^ z >> 31) % static_cast<std::uint64_t>(n));
  }
};

/// A small program with coefficients as they were drawn, to check vertices and Farkas vectors against.
template <class Value>
struct Drawn {
  using Program = LinearProgram<Value>;
  int variables = 0;
  std::vector<typename Program::Row> rows;
  std::vector<std::vector<std::int64_t>> a;
  std::vector<std::int64_t> b;

  explicit Drawn(Stream& from) : variables(static_cast<int>(1 + from.below(4))) {
    const std::int64_t height = 1 + from.below(5);
    for (std::int64_t i = 0; i < height; ++i) {
      std::vector<std::int64_t> row;
      for (int j = 0; j < variables; ++j) row.push_back(from.below(7) - 3);
      if (i > 0 && from.below(4) == 0) row = a[static_cast<std::size_t>(from.below(i))];  // dependent rows
      add(from.below(3) == 0 ? Program::Row::equal : Program::Row::at_most, row, from.below(9) - 3);
    }
  }

  void add(typename Program::Row kind, const std::vector<std::int64_t>& row, std::int64_t right) {
    rows.push_back(kind), a.push_back(row), b.push_back(right);
  }

  Program program() const {
    Program result(variables, rows);
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
      for (int j = 0; j < variables; ++j) result.set_coefficient(i, j, Value(a[i][j]));
      result.set_right_side(i, Value(b[i]));
    }
    return result;
  }

  bool satisfied(const Program& at) const {
    bool holds = at.denominator() > Value(0);
    for (int j = 0; j < variables; ++j) holds = holds && at.numerator(j) >= Value(0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Value left(0);
      for (int j = 0; j < variables; ++j) left += Value(a[i][j]) * at.numerator(j);
      const Value right = Value(b[i]) * at.denominator();
      holds = holds && (rows[i] == Program::Row::equal ? left == right : left <= right);
    }
    return holds;
  }

  bool contradicts(const std::vector<Value>& y) const {
    Value right(0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] == Program::Row::at_most && y[i] < Value(0)) return false;
      right += y[i] * Value(b[i]);
    }
    for (int j = 0; j < variables; ++j) {
      Value column(0);
      for (std::size_t i = 0; i < rows.size(); ++i) column += y[i] * Value(a[i][j]);
      if (column < Value(0)) return false;
    }
    return right < Value(0);
  }
};

std::int64_t number(const Integer& value) { return value.get_si(); }
std::int64_t number(Int128 value) { return static_cast<std::int64_t>(value); }

}  // namespace

TEMPLATE_TEST_CASE(
    "linear program: a vertex satisfies every row, a Farkas vector contradicts them, an optimum cannot be beaten", "",
    Integer, Int128) {
  Stream stream{20240601};
  std::int64_t infeasible = 0, optimal = 0, unbounded = 0, wrong = 0;
  for (int k = 0; k < 40000; ++k) {
    const Drawn<TestType> drawn(stream);
    auto program = drawn.program();
    if (!program.feasible()) {
      ++infeasible, wrong += !drawn.contradicts(program.farkas());
      continue;
    }
    wrong += !drawn.satisfied(program);
    std::vector<std::int64_t> cost;
    std::vector<TestType> exact_cost;
    for (int j = 0; j < drawn.variables; ++j)
      cost.push_back(stream.below(7) - 3), exact_cost.push_back(TestType(cost.back()));
    const bool bounded = program.minimise(exact_cost);
    wrong += !drawn.satisfied(program);
    Drawn<TestType> better = drawn;
    if (bounded) {  // cost . x <= least - 1/1000 of a unit of the denominator is contradicted
      std::int64_t least = 0;
      for (int j = 0; j < drawn.variables; ++j) least += cost[j] * number(program.numerator(j));
      for (std::int64_t& c : cost) c *= 1000 * number(program.denominator());
      better.add(LinearProgram<TestType>::Row::at_most, cost, 1000 * least - 1);
      auto beaten = better.program();
      ++optimal, wrong += beaten.feasible() || !better.contradicts(beaten.farkas());
    } else {
      better.add(LinearProgram<TestType>::Row::at_most, cost, -1000000);
      auto deep = better.program();
      ++unbounded, wrong += !deep.feasible() || !better.satisfied(deep);
    }
  }
  CHECK(wrong == 0);
  CHECK(infeasible > 4000);
  CHECK(optimal > 4000);
  CHECK(unbounded > 4000);
}
