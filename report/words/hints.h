// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// The common features of an engine's wrong answers to an operation, one sentence each. Answers that rounding explains
/// are left out: a formula in double has them whatever its bug is. A hint is based on the other findings of ordinary
/// magnitude that were kept as examples, at least two, and holds for all of them: a touch answered as by open sets;
/// answers that are right if two arguments are exchanged, in a mirrored frame, with another axis up or in degrees
/// (among those that are answers); no question without a move; no short list. That a direction has a component of 0
/// holds for all such findings, kept or not. That numbers are right to seven digits holds for three quarters of those
/// that a float can represent: the others have cancelled. It is a guess at the cause, never a verdict.
std::vector<std::string> hints(const OperationTally& tally, const Declaration& declaration);

}  // namespace touchstone::report
