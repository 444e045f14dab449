// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// True if the faces of all meshes of a question face outwards, as most engines expect. The contract accepts both.
bool looks_outwards(const Operation& operation, const Question& question);

}  // namespace touchstone::catalogue
