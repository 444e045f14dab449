// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// Adds what was answered to the scene of an operation's question `input`, by the shape of its answers: where it can be
/// drawn, differs from the truth, and lies where the input does: else it would shrink everything else to a dot.
void draw_answered(Drawing& scene, const Operation& operation, const Json& answer, const Json& input);

}  // namespace touchstone::report
