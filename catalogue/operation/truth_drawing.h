// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/drawing.h"
#include "catalogue/operation/examination.h"
#include "geometry/invalid_input.h"

namespace touchstone::catalogue {

/// The figure of a question and of the truth about it.
Drawing drawing_of(const Examination& question);
/// The figure of a question that the oracle refuses: its arguments, and the rule that it breaks.
Drawing drawing_of_refused(const Operation& operation, const Question& question, const InvalidInput& refused);

}  // namespace touchstone::catalogue
