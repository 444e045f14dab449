// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// "decision", "measure", "set", "checked", "covering"
const char* name_of(Kind kind);

/// All operations for programs, in the order of the deck: the output of `touchstone ops --json`.
Json listed_operations();

}  // namespace touchstone::catalogue
