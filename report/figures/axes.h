// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/figures/viewport.h"

namespace touchstone::report {

/// Ticks below and left of the frame, in round decimal numbers; where the numbers would all look alike, what the axis
/// spans instead.
std::string ticks(const Viewport& view);

/// The least of 1, 2, 5 times a power of ten that cuts the span into at most five.
mpq_class round_length(const mpq_class& span);

/// Lines through the doubles near (x, y) that lie in the frame, if they are few enough to be told apart, and what to
/// say of them.
struct DoubleGrid {
  std::string svg, caption;
};
DoubleGrid double_grid(const Viewport& view, double x, double y);

}  // namespace touchstone::report
