// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"
#include "report/wording.h"

namespace touchstone::audit {

/// One finding as a card: the figure, what each implementation said and why, the numbers, the command, the certificate.
std::string finding_card(const Operation& operation, const Smallest& smallest, std::uint64_t count,
                         const Declaration& declaration, Speaker speaker, const Repeat& repeat);

}  // namespace touchstone::audit
