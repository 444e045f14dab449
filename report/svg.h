// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "catalogue/draw/drawing.h"
#include "report/uses.h"

namespace touchstone::report {

/// A drawing as SVG. Where a gap of at least `least_gap` is too narrow to be seen, a second frame next to it magnifies
/// it, down to single doubles. `title` is what a screen reader says. Colours are the page's (figure_style); with
/// `standalone` they are brought along.
std::string drawing_svg(const Drawing& drawing, const std::string& title, bool standalone = false,
                        const std::optional<mpq_class>& least_gap = mpq_class(0));

/// The style sheet of figures, over the variables --q0 ... --q3 (parts of the question), --truth, --ink, --faint,
/// --paper, each with a default.
std::string figure_style();

}  // namespace touchstone::report
