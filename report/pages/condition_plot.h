// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// How far the formula in double is from the truth, against the condition of the question, both on scales of powers of
/// two: a dot for each number of some questions of every family, always the same ones. As HTML; empty where the answer
/// is not numbers alone.
std::string condition_section(const Operation& operation);

}  // namespace touchstone::report
