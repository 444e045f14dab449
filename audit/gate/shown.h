// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/gate/gate.h"

/// The text about a finding that the files for CI share.
namespace touchstone::audit {

const char* cause_in_words(Cause cause);

/// "algorithm in 12 of 400 cases, known: 3"; for a finding of an operation without a family its cause and its meaning.
std::string in_words(const GateEntry& entry);

/// The best example of an entry within its family; nullptr if there is none.
const Finding* example_of(const Tally& tally, const Found& found);

/// Several lines: the id if it is a test vector, input, the same in hexadecimal, truth, answer, its judgement, and the
/// shell command that repeats it. Printable ASCII.
std::string described(const Tally& tally, const std::string& operation, const Finding& finding, bool of_robust = false);

}  // namespace touchstone::audit
