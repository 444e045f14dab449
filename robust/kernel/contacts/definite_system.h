// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <map>
#include <optional>
#include <vector>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// A symmetric, positive semidefinite matrix of integers, few of which are not 0: by row and column, both halves.
using SparseMatrix = std::vector<std::map<std::size_t, mpz_class>>;

/// numerators[k][i] / denominator solves the equations for right side k; the denominator is positive.
struct Solution {
  std::vector<std::vector<mpz_class>> numerators;
  mpz_class denominator;
};

/// Exact elimination without fractions (Bareiss): all numbers are minors, so every division is without remainder, and
/// one that elimination does not reach stays as it is until it does. The row with the fewest numbers comes first: the
/// matrix of a chain stays as sparse as it is.
///
/// dependent: a row that is a combination of others, where the matrix is not definite; then there is no solution.
std::optional<Solution> solve(const SparseMatrix& matrix, const std::vector<std::vector<mpz_class>>& right_sides,
                              std::size_t& dependent);

}  // namespace touchstone::robust::kernel
