// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// Adds an answer to the scene of an operation's question, by the shape of its answers or, if the operation draws its
/// own, like the truth. Only if it can be drawn, differs from the truth, and lies near the input: otherwise it would
/// shrink everything else to a dot.
void draw_answered(Drawing& scene, const Operation& operation, const Json& answer, const Question& question);

}  // namespace touchstone::report
