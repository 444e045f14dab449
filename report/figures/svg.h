// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// The element that contains a figure's svg element.
inline constexpr const char* view_opening = "<div class=\"view\">";

/// A drawing as SVG in HTML. If a gap of at least `least_gap` is too narrow to be visible, a second figure next to it,
/// or below on narrow pages, magnifies it, down to single doubles. `title` is for screen readers. Colours are the
/// page's (figure_style).
std::string drawing_svg(const Drawing& drawing, const std::string& title,
                        const std::optional<mpq_class>& least_gap = mpq_class(0));

/// The style sheet of figures, over the variables --q0 ... --q3 (parts of the question), --truth, --ink, --faint,
/// --paper, each with a default.
std::string figure_style();

}  // namespace touchstone::report
