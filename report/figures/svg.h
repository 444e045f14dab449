// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// A figure's svg element stands in one of these.
inline constexpr const char* view_opening = "<div class=\"view\">";

/// A drawing as SVG in HTML. Where a gap of at least `least_gap` is too narrow to be seen, a second figure next to it,
/// or below where the page is narrow, magnifies it, down to single doubles. `title` is what a screen reader says.
/// Colours are the page's (figure_style).
std::string drawing_svg(const Drawing& drawing, const std::string& title,
                        const std::optional<mpq_class>& least_gap = mpq_class(0));

/// The style sheet of figures, over the variables --q0 ... --q3 (parts of the question), --truth, --ink, --faint,
/// --paper, each with a default.
std::string figure_style();

}  // namespace touchstone::report
