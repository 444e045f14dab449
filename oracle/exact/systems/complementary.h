// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// w = M z + q with w, z >= 0 and w . z = 0, for M symmetric and positive semidefinite, on integers.
struct Complementary {
  std::vector<std::vector<Integer>> matrix;
  std::vector<Integer> constants;
};

/// solved: z is numerators / denominator, which is positive. Otherwise no w, z >= 0 satisfy the equations: then the
/// numerators y are not negative, M y = 0 and q . y < 0.
struct Complement {
  bool solved;
  std::vector<Integer> numerators;
  Integer denominator;
};

/// Lemke's complementary pivoting: an artificial variable makes w >= 0, and the variable that left the basis is
/// followed by its complement until the artificial one leaves, or the entering one is unbounded. The row is chosen
/// lexicographically, so no basis repeats. The tableau consists of integers over one common denominator, minors of the
/// input, so that every division is exact.
Complement lemke(const Complementary& problem);

}  // namespace touchstone::oracle
