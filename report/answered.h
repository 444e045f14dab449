// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"
#include "catalogue/drawing.h"

namespace touchstone::audit {

/// Adds what was answered, where it can be drawn, differs from the truth, and lies where the input does: else it
/// would shrink everything else to a dot.
/// `input`: the question, whose points an answer of indices means.
void draw_answered(Drawing& drawing, const Json& answer, const Json& input = nullptr);

}  // namespace touchstone::audit
