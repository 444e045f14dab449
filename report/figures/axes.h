// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/figures/viewport.h"

namespace touchstone::report {

/// Ticks below and left of the frame, in round decimal numbers; if the numbers would all look alike, the range of the
/// axis instead.
std::string ticks(const Viewport& view);

/// The least of 1, 2, 5 times a power of ten that divides the span into at most five steps.
mpq_class round_length(const mpq_class& span);

/// Lines through the doubles near (x, y) that lie in the frame, if they are few enough to be distinguished, and a text
/// about them.
struct DoubleGrid {
  std::string svg, caption;
};
DoubleGrid double_grid(const Viewport& view, double x, double y);

}  // namespace touchstone::report
