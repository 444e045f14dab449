// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"

/// Two audits beside each other, as before and after a fix.
namespace touchstone::audit {

/// Every operation that both have, what changed most first; as HTML with its heading.
std::string comparison(const Tally& before, const Tally& after);
/// One operation, with the families that changed; empty where the earlier audit does not have it.
std::string comparison(const Tally& before, const Tally& after, const std::string& operation);

}  // namespace touchstone::audit
