// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/uses.h"
#include "catalogue/operation/examination.h"

namespace touchstone::audit {

/// The key by which two vectors are alike: the outcome and the textbook formula's verdict.
std::string likeness(const Examination& examination);

}  // namespace touchstone::audit
