// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <map>
#include <optional>
#include <vector>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// A symmetric, positive semidefinite sparse matrix of integers: by row and column, both halves.
using SparseMatrix = std::vector<std::map<std::size_t, mpz_class>>;

/// numerators[k][i] / denominator solves the equations for right side k; the denominator is positive.
struct Solution {
  std::vector<std::vector<mpz_class>> numerators;
  mpz_class denominator;
};

/// Exact fraction-free elimination (Bareiss): all numbers are minors, so every division is exact, and an entry that
/// elimination does not reach stays unchanged until it does. The row with the fewest numbers comes first: the matrix of
/// a chain stays as sparse as it is.
///
/// dependent: a row that is a combination of others, if the matrix is not definite; then there is no solution.
std::optional<Solution> solve(const SparseMatrix& matrix, const std::vector<std::vector<mpz_class>>& right_sides,
                              std::size_t& dependent);

}  // namespace touchstone::robust::kernel
