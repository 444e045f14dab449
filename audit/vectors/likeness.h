// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"
#include "catalogue/operation/examination.h"

namespace touchstone::audit {

/// What makes two vectors alike: the outcome and what the textbook formula makes of it.
std::string likeness(const Examination& examination);

}  // namespace touchstone::audit
