// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/definite_system.h"

namespace touchstone::robust::kernel {
namespace {

/// A minor, and the number of eliminations that it includes.
struct Entry {
  mpz_class value;
  std::size_t level = 0;
};

class Elimination {
 public:
  Elimination(const SparseMatrix& matrix, const std::vector<std::vector<mpz_class>>& right_sides)
      : size_(matrix.size()), rows_(size_), right_(size_), minors_{1} {
    for (std::size_t i = 0; i < size_; ++i) {
      for (const auto& [j, number] : matrix[i])
        if (sgn(number) != 0) rows_[i][j] = {number};
      for (const auto& side : right_sides) right_[i].push_back({side[i]});
    }
  }

  /// Returns true if no row depends on those before it; otherwise `row` is one that does.
  bool eliminated(std::size_t& row) {
    std::vector<bool> done(size_);
    for (std::size_t step = 0; step < size_; ++step) {
      row = size_;
      for (std::size_t i = 0; i < size_; ++i)
        if (!done[i] && (row == size_ || rows_[i].size() < rows_[row].size())) row = i;
      const auto pivot = rows_[row].find(row);
      if (pivot == rows_[row].end() || sgn(pivot->second.value) == 0) return false;
      lift(pivot->second, step);
      minors_.push_back(pivot->second.value);
      rows_[row].erase(pivot);
      done[row] = true, order_.push_back(row);
      reduce(row);
    }
    return true;
  }

  Solution solution(std::size_t sides) const {
    Solution found{std::vector<std::vector<mpz_class>>(sides, std::vector<mpz_class>(size_)), minors_.back()};
    for (std::size_t step = size_; step-- > 0;) {
      const std::size_t i = order_[step];
      for (std::size_t k = 0; k < sides; ++k) {
        mpz_class& x = found.numerators[k][i];
        x = right_[i][k].value * found.denominator;
        for (const auto& [j, entry] : rows_[i]) x -= entry.value * found.numerators[k][j];
        mpz_divexact(x.get_mpz_t(), x.get_mpz_t(), minors_[step + 1].get_mpz_t());
      }
    }
    return found;
  }

 private:
  /// Brings the entry to that number of eliminations, all of which keep its quotient by the minor.
  void lift(Entry& entry, std::size_t level) const {
    if (entry.level == level) return;
    entry.value *= minors_[level];
    mpz_divexact(entry.value.get_mpz_t(), entry.value.get_mpz_t(), minors_[entry.level].get_mpz_t());
    entry.level = level;
  }
  /// entry = (minor entry - left right) / minor before
  void subtract(Entry& entry, const mpz_class& left, const mpz_class& right) {
    const std::size_t level = order_.size();
    lift(entry, level - 1);
    entry.value = entry.value * minors_[level] - left * right;
    mpz_divexact(entry.value.get_mpz_t(), entry.value.get_mpz_t(), minors_[level - 1].get_mpz_t());
    entry.level = level;
  }
  void reduce(std::size_t row) {
    const std::size_t before = order_.size() - 1;
    for (auto& [j, entry] : rows_[row]) lift(entry, before), rows_[j].erase(row);
    for (Entry& entry : right_[row]) lift(entry, before);
    for (const auto& [j, left] : rows_[row]) {
      for (const auto& [k, right] : rows_[row]) {
        if (k < j) continue;
        subtract(rows_[j][k], left.value, right.value);
        if (k != j) rows_[k][j] = rows_[j][k];
      }
      for (std::size_t k = 0; k < right_[row].size(); ++k) subtract(right_[j][k], left.value, right_[row][k].value);
    }
  }

  std::size_t size_;
  std::vector<std::map<std::size_t, Entry>> rows_;
  std::vector<std::vector<Entry>> right_;
  std::vector<mpz_class> minors_;  // of the rows eliminated so far, beginning with the minor of no rows
  std::vector<std::size_t> order_;
};

}  // namespace

std::optional<Solution> solve(const SparseMatrix& matrix, const std::vector<std::vector<mpz_class>>& right_sides,
                              std::size_t& dependent) {
  Elimination elimination(matrix, right_sides);
  if (!elimination.eliminated(dependent)) return std::nullopt;
  return elimination.solution(right_sides.size());
}

}  // namespace touchstone::robust::kernel
