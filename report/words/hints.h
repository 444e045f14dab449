// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// What the wrong answers of an engine to an operation have in common, a sentence each. Answers that rounding explains
/// are left out: a formula in double has them whatever its bug is. A hint goes by the other findings of ordinary size
/// that were kept as examples, two at least, and holds for all of them: a touch answered as open sets do; answers that
/// are right if two arguments are exchanged, in a mirrored frame, with another axis up or in degrees (of those that are
/// answers); no question without a move; no short list. That a direction has a component of 0 holds for all such
/// findings, kept or not. That numbers are right to seven digits holds for three quarters of those that a float has:
/// the others have cancelled. It is a guess at the cause, never a verdict.
std::vector<std::string> hints(const OperationTally& tally, const Declaration& declaration);

}  // namespace touchstone::report
