// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/report/labels.h"
#include "audit/report/scene.h"
#include "audit/report/viewport.h"

namespace touchstone::audit {

/// What has been drawn in one frame.
struct Drawing {
  std::string lines, points;  ///< SVG; points are to lie above lines
  std::vector<Pixel> drawn;   ///< places that a text should leave free
  std::vector<LabelWish> wishes;
};

/// Adds a figure as it is seen in the view, in the style class `style`.
void stroke(Drawing& drawing, const Figure& figure, const Viewport& view, const std::string& style);

}  // namespace touchstone::audit
