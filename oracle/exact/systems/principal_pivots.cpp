// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/principal_pivots.h"

namespace touchstone::oracle {
namespace {

/// The greatest common divisor of all numbers, which are divided by it; 1 if all are 0.
Integer common_factor(const std::vector<std::vector<Integer>*>& rows) {
  Integer common(0);
  for (const auto* row : rows) {
    for (const Integer& number : *row) mpz_gcd(common.get_mpz_t(), common.get_mpz_t(), number.get_mpz_t());
  }
  if (sgn(common) == 0) return 1;
  for (auto* row : rows) {
    for (Integer& number : *row) mpz_divexact(number.get_mpz_t(), number.get_mpz_t(), common.get_mpz_t());
  }
  return common;
}

/// Each row is one variable of a pair, w or z, as a sum of multiples of the other variables of all pairs, which are 0,
/// and a constant: all over one positive denominator.
class Dictionary {
 public:
  explicit Dictionary(const Complementary& problem)
      : n_(problem.constants.size()), matrix_(problem.matrix), constants_(problem.constants), solves_for_z_(n_) {
    // Masses and normals of few digits are far above their unit.
    std::vector<std::vector<Integer>*> rows;
    for (auto& row : matrix_) rows.push_back(&row);
    of_matrix_ = common_factor(rows), of_constants_ = common_factor({&constants_});
  }

  std::optional<Complement> solved() {
    for (std::size_t i = 0; i < n_; ++i) {
      if (sgn(constants_[i]) < 0 && !raised(i)) return std::nullopt;
    }
    // If w and z are both 0, z might push if the columns of those that may push are dependent: then some diagonal of 0
    // remains.
    for (std::size_t i = 0; i < n_; ++i) {
      if (!solves_for_z_[i] && sgn(constants_[i]) == 0 && !pivot(i)) return std::nullopt;
    }
    Complement found{true, std::vector<Integer>(n_), denominator_ * of_matrix_};
    for (std::size_t i = 0; i < n_; ++i) {
      if (solves_for_z_[i]) found.numerators[i] = constants_[i] * of_constants_;
    }
    return found;
  }

 private:
  /// Returns true if variable `raise`, below 0, was brought to 0 by its complement, while no nonnegative one fell below
  /// it.
  bool raised(std::size_t raise) {
    std::vector<bool> kept(n_);
    for (std::size_t i = 0; i < n_; ++i) kept[i] = sgn(constants_[i]) >= 0;
    for (;;) {
      std::size_t first = raise;  // to reach 0, by -constant / entry
      if (sgn(matrix_[raise][raise]) <= 0) return false;
      for (std::size_t i = 0; i < n_; ++i) {
        if (!kept[i] || sgn(matrix_[i][raise]) >= 0) continue;
        // Both ratios are positive fractions, of which this one's numerator and denominator have changed signs.
        const Integer &at_i = matrix_[i][raise], &at_first = matrix_[first][raise];
        if (constants_[i] * abs(at_first) < abs(constants_[first]) * -at_i) first = i;
      }
      if (pivots_++ == 8 * n_ || !pivot(first)) return false;
      if (first == raise) return true;
    }
  }

  /// Makes the variable of that row and its complement change places.
  bool pivot(std::size_t k) {
    const Integer entry = matrix_[k][k];
    if (sgn(entry) <= 0) return false;
    const auto updated = [&](Integer& number, const Integer& factor, const Integer& in_row) {
      if (sgn(number) == 0 && (sgn(factor) == 0 || sgn(in_row) == 0)) return;
      number *= entry;
      mpz_submul(number.get_mpz_t(), factor.get_mpz_t(), in_row.get_mpz_t());
      mpz_divexact(number.get_mpz_t(), number.get_mpz_t(), denominator_.get_mpz_t());
    };
    for (std::size_t i = 0; i < n_; ++i) {
      const Integer& factor = matrix_[i][k];
      if (i == k || (sgn(factor) == 0 && entry == denominator_)) continue;
      for (std::size_t j = 0; j < n_; ++j) {
        if (j != k) updated(matrix_[i][j], factor, matrix_[k][j]);
      }
      updated(constants_[i], factor, constants_[k]);
    }
    for (std::size_t j = 0; j < n_; ++j) {
      if (j != k) mpz_neg(matrix_[k][j].get_mpz_t(), matrix_[k][j].get_mpz_t());
    }
    mpz_neg(constants_[k].get_mpz_t(), constants_[k].get_mpz_t());
    matrix_[k][k] = denominator_, denominator_ = entry;
    solves_for_z_[k] = !solves_for_z_[k];
    return true;
  }

  std::size_t n_, pivots_ = 0;
  std::vector<std::vector<Integer>> matrix_;
  std::vector<Integer> constants_;
  std::vector<bool> solves_for_z_;
  Integer denominator_ = 1, of_matrix_, of_constants_;
};

}  // namespace

std::optional<Complement> single_complement(const Complementary& problem) { return Dictionary(problem).solved(); }

}  // namespace touchstone::oracle
