// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/drawing.h"

namespace touchstone::audit {

/// A scene's figures in space as SVG, seen from before, above and the right, with what the script of the page needs
/// to turn them. `title` is what a screen reader says. Empty where there is nothing to draw.
std::string space_svg(const Drawing& scene, const std::string& title);

/// Whether a page has such a figure, and so is in need of the script.
bool has_space_svg(const std::string& html);

/// The style sheet of such figures, beside that of figures in the plane (svg.h).
std::string space_style();

}  // namespace touchstone::audit
