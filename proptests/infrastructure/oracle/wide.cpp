// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/wide.h"

#include <algorithm>

#include "catalogue/families/draw_stream.h"
#include "oracle/exact/systems/linear_program.h"
#include "proptests/catch.h"

namespace touchstone::proptests::wide_tests {
namespace {

using namespace oracle;
using catalogue::DrawStream;

/// At most so many bits, often at one end of them or next to a power of two.
Int128 drawn(DrawStream& draws, int bits) {
  const auto size = static_cast<int>(draws.below(static_cast<std::uint64_t>(bits) + 1));
  const UInt128 mask = (UInt128{1} << size) - 1;
  const UInt128 high = draws.any_bits(), any = high << 64 | draws.any_bits();
  const auto form = draws.below(3);
  const UInt128 value = form == 0 ? any & mask : form == 1 ? mask : (mask >> 1) + 1;
  return draws.below(2) == 0 ? static_cast<Int128>(value) : -static_cast<Int128>(value);
}

template <class Value>
Integer integer(const Value& value) {
  return rational(value).get_num();
}

int sign_of_difference(const Wide& a, const Wide& b) { return a < b ? -1 : b < a ? 1 : 0; }

}  // namespace

TEST_CASE("wide integers: products, differences, orders and exact quotients are GMP's") {
  DrawStream draws = DrawStream::seeded(20240607);
  int wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    const Int128 a = drawn(draws, 126), b = drawn(draws, 126), c = drawn(draws, 126), d = drawn(draws, 126);
    const Integer p(integer(a) * integer(b)), q(integer(c) * integer(d)), difference(p - q);
    wrong += integer(product(a, b)) != p || integer(product(a, b) - product(c, d)) != difference;
    wrong += sign_of_difference(product(a, b), product(c, d)) != sgn(difference);
    wrong += sgn(product(a, b)) != sgn(p) || (product(a, b) == product(c, d)) != (p == q);
    wrong += b != 0 && ExactDivision<Int128>(b)(product(a, b)) != a;
    wrong += b != 0 && quotient(product(a, c), b) != Rational(integer(a) * integer(c)) / Rational(integer(b));
    wrong += absolute(a) != Rational(abs(integer(a)));
  }
  CHECK(wrong == 0);
}

TEST_CASE("linear program: 128-bit integers give what GMP's give, up to the size that they are used for") {
  DrawStream draws = DrawStream::seeded(20240608);
  using Row = LinearProgram<Integer>::Row;
  int different = 0, feasible = 0, infeasible = 0;
  for (int i = 0; i < 20000; ++i) {
    LinearProgram<Int128> words(2, {LinearProgram<Int128>::Row::equal, LinearProgram<Int128>::Row::equal,
                                    LinearProgram<Int128>::Row::at_most, LinearProgram<Int128>::Row::at_most});
    LinearProgram<Integer> wholes(2, {Row::equal, Row::equal, Row::at_most, Row::at_most});
    const int bits = draws.below(2) == 0 ? 62 : 3;
    const auto set = [&](int row, int column, Int128 value) {
      if (column < 2) {
        words.set_coefficient(row, column, value), wholes.set_coefficient(row, column, integer(value));
      } else {
        words.set_right_side(row, value), wholes.set_right_side(row, integer(value));
      }
    };
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 3; ++column) set(row, column, drawn(draws, bits));
    }
    set(2, 1, 1), set(2, 2, 1), set(3, 0, 1), set(3, 2, 1);
    const bool found = words.feasible();
    different += found != wholes.feasible();
    ++(found ? feasible : infeasible);
    if (found) {
      words.minimise({-1, 0}), wholes.minimise({Integer(-1), Integer(0)});
      different += integer(words.denominator()) != wholes.denominator();
      for (int j = 0; j < 2; ++j) different += integer(words.numerator(j)) != wholes.numerator(j);
    } else {
      for (std::size_t row = 0; row < 4; ++row) different += integer(words.farkas()[row]) != wholes.farkas()[row];
    }
  }
  CHECK(different == 0);
  CHECK(feasible > 1000);
  CHECK(infeasible > 1000);
}

}  // namespace touchstone::proptests::wide_tests
