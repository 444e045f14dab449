// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/draw/drawing.h"
#include "report/figures/labels.h"
#include "report/figures/viewport.h"

namespace touchstone::report {

/// What has been drawn in one frame.
struct Strokes {
  std::string lines, points;  ///< SVG; points are to lie above lines
  std::vector<Pixel> drawn;   ///< places that a text should leave free
  std::vector<LabelWish> wishes;
};

/// A style class, and how thick its strokes are: what is drawn first is thicker, so that it is still seen beneath what
/// coincides with it.
struct Style {
  std::string name;
  double thickness = 2;
  bool corners = true;  ///< those of polygons are dots
};

/// Adds a figure as it is seen in the view.
void stroke(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style);

}  // namespace touchstone::report
