// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Two audits next to each other, as before and after a fix, as HTML with its heading: every operation that both have,
/// the greatest change first; for one operation, the families that changed; empty if the earlier audit does not have
/// it.
std::string comparison(const Tally& before, const Tally& after, const std::string& operation = "");

}  // namespace touchstone::report
