// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// Whether the faces of all meshes of a question look outwards, as most engines expect. The contract takes both.
bool looks_outwards(const Operation& operation, const Question& question);

}  // namespace touchstone::catalogue
