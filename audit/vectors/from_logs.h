// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The hardest questions of recorded calls, by operation: those with a wrong answer, and those on which the textbook
/// formula is as near to another course as its own rounding. Each is shrunk while the truth, whether shapes only touch,
/// and the formula's verdict stay the same; duplicates are dropped. A few of each such kind are kept, the smallest
/// first. The same logs give the same questions whatever `jobs` is.
std::map<const Operation*, std::vector<Question>> hardest_of_logs(const std::vector<std::string>& files,
                                                                  const std::vector<const Operation*>& operations,
                                                                  int jobs);

}  // namespace touchstone::audit
