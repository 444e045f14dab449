// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// The distance of the formula in double from the truth, against the condition of the question, both on logarithmic
/// scales: a dot for each number of some questions of every family, always the same ones. As HTML; empty unless the
/// answer is numbers alone.
std::string condition_section(const Operation& operation);

}  // namespace touchstone::report
