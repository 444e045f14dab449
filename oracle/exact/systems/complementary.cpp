// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/complementary.h"

#include <utility>

namespace touchstone::oracle {
namespace {

/// Rows (w | z | artificial | constants) of I w - M z - 1 artificial = q.
class Tableau {
 public:
  explicit Tableau(const Complementary& problem) : n_(problem.constants.size()), denominator_(1) {
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<Integer> row(2 * n_ + 2);
      row[i] = 1, row[artificial()] = -1, row[constants()] = problem.constants[i];
      for (std::size_t j = 0; j < n_; ++j) row[n_ + j] = -problem.matrix[i][j];
      rows_.push_back(std::move(row)), basic_.push_back(i);
    }
  }

  Complement solved() {
    std::size_t row = 0, entering = artificial();
    for (std::size_t i = 1; i < n_; ++i)  // with equal constants the later is less: its w is farther right
      if (rows_[i][constants()] <= rows_[row][constants()]) row = i;
    if (n_ == 0 || sgn(rows_[row][constants()]) >= 0) return basis();
    for (Integer& number : rows_[row]) number = -number;
    for (;;) {
      const std::size_t left = pivot(row, entering);
      if (left == artificial() || artificial_is_zero()) return basis();
      entering = left < n_ ? left + n_ : left - n_;
      const auto bounding = leaving_row(entering);
      if (!bounding) return ray(entering);
      row = *bounding;
    }
  }

 private:
  std::size_t artificial() const { return 2 * n_; }
  std::size_t constants() const { return 2 * n_ + 1; }

  bool artificial_is_zero() const {
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] == artificial()) return sgn(rows_[i][constants()]) == 0;
    return true;
  }

  /// True if row i over its entry comes before row k over its own: by the constants, then by the columns of w.
  bool before(std::size_t i, std::size_t k, std::size_t column) const {
    const Integer &at_i = rows_[i][column], &at_k = rows_[k][column];
    Integer difference = rows_[i][constants()] * at_k - rows_[k][constants()] * at_i;
    for (std::size_t j = 0; j < n_ && sgn(difference) == 0; ++j) difference = rows_[i][j] * at_k - rows_[k][j] * at_i;
    return sgn(difference) < 0;
  }
  std::optional<std::size_t> leaving_row(std::size_t column) const {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < n_; ++i)
      if (sgn(rows_[i][column]) > 0 && (!least || before(i, *least, column))) least = i;
    return least;
  }

  /// The variable that leaves. The entry is positive.
  std::size_t pivot(std::size_t row, std::size_t column) {
    const Integer entry = rows_[row][column];
    for (std::size_t i = 0; i < n_; ++i) {
      if (i == row) continue;
      const Integer factor = rows_[i][column];
      for (std::size_t j = 0; j < 2 * n_ + 2; ++j) {
        Integer& number = rows_[i][j];
        const Integer& in_row = rows_[row][j];
        if (sgn(number) == 0 && (sgn(factor) == 0 || sgn(in_row) == 0)) continue;
        number *= entry;
        mpz_submul(number.get_mpz_t(), factor.get_mpz_t(), in_row.get_mpz_t());
        mpz_divexact(number.get_mpz_t(), number.get_mpz_t(), denominator_.get_mpz_t());
      }
    }
    denominator_ = entry;
    return std::exchange(basic_[row], column);
  }

  Complement basis() const {
    Complement found{true, std::vector<Integer>(n_), denominator_};
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] >= n_ && basic_[i] < 2 * n_) found.numerators[basic_[i] - n_] = rows_[i][constants()];
    return found;
  }

  /// z along the direction in which the entering variable is unbounded. M is copositive plus, so M z = 0 there and q .
  /// z < 0 (Cottle, Pang, Stone: The Linear Complementarity Problem, section 4.4).
  Complement ray(std::size_t entering) const {
    Complement found{false, std::vector<Integer>(n_), denominator_};
    if (entering >= n_) found.numerators[entering - n_] = denominator_;
    for (std::size_t i = 0; i < n_; ++i)
      if (basic_[i] >= n_ && basic_[i] < 2 * n_) found.numerators[basic_[i] - n_] = -rows_[i][entering];
    return found;
  }

  std::size_t n_;
  std::vector<std::vector<Integer>> rows_;
  std::vector<std::size_t> basic_;
  Integer denominator_;
};

}  // namespace

Complement lemke(const Complementary& problem) { return Tableau(problem).solved(); }

}  // namespace touchstone::oracle
