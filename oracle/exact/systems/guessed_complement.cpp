// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/guessed_complement.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <map>

namespace touchstone::oracle {
namespace {

using ContactPlaces = std::vector<std::size_t>;

/// The problem in doubles, each contact in a unit of its own, so that the diagonal is about 1. Numbers near 0 count as
/// 0: nothing here has to be right.
class GuessedPivots {
 public:
  explicit GuessedPivots(const Complementary& problem) : n_(problem.constants.size()), solves_for_z_(n_) {
    std::vector<std::int64_t> units;
    for (std::size_t i = 0; i < n_; ++i) units.push_back(exponent_of(problem.matrix[i][i]) / 2);
    std::optional<std::int64_t> most;
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<double>& row = matrix_.emplace_back();
      for (std::size_t j = 0; j < n_; ++j) row.push_back(in_unit(problem.matrix[i][j], units[i] + units[j]));
      if (sgn(problem.constants[i]) != 0)
        most = std::max(most.value_or(LONG_MIN), exponent_of(problem.constants[i]) - units[i]);
    }
    for (std::size_t i = 0; i < n_; ++i)
      constants_.push_back(in_unit(problem.constants[i], most.value_or(0) + units[i]));
  }

  /// The nonzero z, if the pivots come to an end.
  std::optional<ContactPlaces> found() {
    for (std::size_t i = 0; i < n_; ++i)
      if (constants_[i] < -tiny && !raised(i)) return std::nullopt;
    ContactPlaces found;
    for (std::size_t i = 0; i < n_; ++i)
      if (solves_for_z_[i]) found.push_back(i);
    return found;
  }

 private:
  static constexpr double tiny = 0x1p-40;

  static std::int64_t exponent_of(const Integer& number) {
    return static_cast<std::int64_t>(mpz_sizeinbase(number.get_mpz_t(), 2));
  }
  static double in_unit(const Integer& number, std::int64_t unit) {
    std::int64_t exponent = 0;
    const double part = mpz_get_d_2exp(&exponent, number.get_mpz_t());
    return std::ldexp(part, static_cast<int>(std::clamp<std::int64_t>(exponent - unit, -2000, 2000)));
  }

  bool raised(std::size_t raise) {
    for (;;) {
      if (matrix_[raise][raise] <= tiny) return false;
      std::size_t first = raise;
      double displacement = -constants_[raise] / matrix_[raise][raise];
      for (std::size_t i = 0; i < n_; ++i) {
        if (i == raise || constants_[i] < -tiny || matrix_[i][raise] >= -tiny) continue;
        const double there = std::max(constants_[i], 0.0) / -matrix_[i][raise];
        if (there < displacement) first = i, displacement = there;
      }
      if (pivots_++ == 8 * n_ || matrix_[first][first] <= tiny) return false;
      pivot(first);
      if (first == raise) return true;
    }
  }

  void pivot(std::size_t k) {
    std::vector<double>& own = matrix_[k];
    const double entry = own[k];
    for (double& number : own) number /= -entry;
    own[k] = 1 / entry, constants_[k] /= -entry;
    for (std::size_t i = 0; i < n_; ++i) {
      const double factor = matrix_[i][k];
      if (i == k || factor == 0) continue;
      matrix_[i][k] = 0;
      for (std::size_t j = 0; j < n_; ++j) matrix_[i][j] += factor * own[j];
      constants_[i] += factor * constants_[k];
    }
    solves_for_z_[k] = !solves_for_z_[k];
  }

  std::size_t n_, pivots_ = 0;
  std::vector<std::vector<double>> matrix_;
  std::vector<double> constants_;
  std::vector<bool> solves_for_z_;
};

/// The z at these indices with which w is 0 there, all others being 0; nullopt if there are several. The row with the
/// fewest numbers is eliminated first.
std::optional<std::vector<Rational>> solution_at(const Complementary& problem, const ContactPlaces& places) {
  const std::size_t n = places.size();
  std::vector<std::map<std::size_t, Rational>> rows(n);
  std::vector<Rational> sides;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < n; ++l)
      if (const Integer& number = problem.matrix[places[k]][places[l]]; sgn(number) != 0) rows[k][l] = number;
    sides.emplace_back(-problem.constants[places[k]]);
  }
  std::vector<bool> done(n);
  ContactPlaces order;
  while (order.size() < n) {
    std::size_t row = n;
    for (std::size_t k = 0; k < n; ++k)
      if (!done[k] && (row == n || rows[k].size() < rows[row].size())) row = k;
    const auto pivot = rows[row].find(row);
    if (pivot == rows[row].end() || sgn(pivot->second) == 0) return std::nullopt;
    done[row] = true, order.push_back(row);
    for (const auto& [k, unused] : rows[row]) {
      if (done[k]) continue;
      const Rational times = rows[k].at(row) / pivot->second;
      for (const auto& [l, number] : rows[row]) {
        if (l == row) continue;
        Rational& entry = rows[k][l];
        entry -= times * number;
        if (sgn(entry) == 0) rows[k].erase(l);
      }
      rows[k].erase(row);
      sides[k] -= times * sides[row];
    }
  }
  for (auto step = order.rbegin(); step != order.rend(); ++step) {
    Rational& z = sides[*step];
    for (const auto& [l, number] : rows[*step])
      if (l != *step) z -= number * sides[l];
    z /= rows[*step].at(*step);
  }
  return sides;
}

}  // namespace

std::optional<Complement> guessed_complement(const Complementary& problem) {
  const std::size_t n = problem.constants.size();
  std::optional<ContactPlaces> places = GuessedPivots(problem).found();
  for (bool again = true; places && again;) {
    again = false;
    const auto z = solution_at(problem, *places);
    if (!z || std::any_of(z->begin(), z->end(), [](const Rational& one) { return sgn(one) < 0; })) return std::nullopt;
    ContactPlaces level;  // where w is 0
    for (std::size_t i = 0, next = 0; i < n; ++i) {
      if (next < places->size() && (*places)[next] == i) {
        level.push_back(i), ++next;
        continue;
      }
      Rational w = problem.constants[i];
      for (std::size_t k = 0; k < places->size(); ++k)
        if (const Integer& number = problem.matrix[i][(*places)[k]]; sgn(number) != 0) w += number * (*z)[k];
      if (sgn(w) < 0) return std::nullopt;
      if (sgn(w) == 0) level.push_back(i);
    }
    if (level.size() != places->size()) {
      places = std::move(level), again = true;
      continue;
    }
    Complement found{true, std::vector<Integer>(n), 1};
    for (const Rational& one : *z)
      mpz_lcm(found.denominator.get_mpz_t(), found.denominator.get_mpz_t(), one.get_den_mpz_t());
    for (std::size_t k = 0; k < z->size(); ++k)
      found.numerators[(*places)[k]] = (*z)[k].get_num() * Integer(found.denominator / (*z)[k].get_den());
    return found;
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle
