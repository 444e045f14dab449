// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// A number of an answer that is not 0.
struct Sensitivity {
  /// The condition of the question, for this number: by how many times its relative change exceeds that of the
  /// question's numbers, the sum over all of them. 2^k says that k of its digits depend on the last digit of the input.
  double condition;
  double ulps;  ///< how far the formula in double is from the truth
};

/// Those of a question whose answer is numbers alone; of others, none. Each derivative is a quotient of differences:
/// the truth is asked once more with the number moved by 2^-32 of itself, or to the next double. Throws InvalidInput
/// where the oracle refuses the question.
std::vector<Sensitivity> sensitivities(const Operation& operation, const Question& question);

}  // namespace touchstone::catalogue
