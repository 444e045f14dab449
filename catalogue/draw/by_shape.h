// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/draw/drawing.h"
#include "catalogue/shape/shape.h"

/// Draws values whose types are known only by their shapes.
namespace touchstone::catalogue {

/// Draws a value and moves the cursor past it. Returns false and does nothing if the type has no figure of its own.
bool draw_figure(Drawing& drawing, const Shape& shape, const std::string& label, Cursor<double>& from, bool answer);
bool has_figure(const Shape& shape);

/// Draws a question's arguments by their types; arguments without a figure are noted in words.
void draw_question(Drawing& drawing, const Shape& shape, const Question& question);

}  // namespace touchstone::catalogue
