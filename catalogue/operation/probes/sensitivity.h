// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// A nonzero number of an answer.
struct Sensitivity {
  /// The condition of the question, for this number: the factor by which its relative change exceeds that of the
  /// question's numbers, the sum over all of them. 2^k means that k of its digits depend on the last digit of the
  /// input.
  double condition;
  double ulps;  ///< the distance of the formula in double from the truth
};

/// The sensitivities of a question whose answer is numbers alone; empty for others. Each derivative is a quotient of
/// differences: the truth is computed again with the number moved by 2^-32 of itself, or to the next double. Throws
/// InvalidInput if the oracle refuses the question.
std::vector<Sensitivity> sensitivities(const Operation& operation, const Question& question);

}  // namespace touchstone::catalogue
