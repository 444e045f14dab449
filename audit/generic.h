// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// Whether no three of a question's points lie on one line, exactly; two equal points lie on a line with any third.
/// Only the first eight points are looked at, in the plane and in space alike. An example of which that is true shows a
/// bug that needs no degenerate input, as far as one can tell without knowing the operation.
bool in_general_position(const Operation& operation, const Question& question);

}  // namespace touchstone::audit
