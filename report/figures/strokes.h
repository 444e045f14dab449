// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/draw/drawing.h"
#include "report/figures/labels.h"
#include "report/figures/viewport.h"

namespace touchstone::report {

/// The contents of one frame.
struct Strokes {
  std::string lines, points;  ///< SVG; points are drawn above lines
  std::vector<Pixel> drawn;   ///< positions that a text should leave free
  std::vector<LabelWish> wishes;
};

/// A style class, and the thickness of its strokes: earlier figures are thicker, so that they are visible beneath later
/// ones that coincide with them.
struct Style {
  std::string name;
  double thickness = 2;
  bool corners = true;  ///< those of polygons are dots
};

/// Adds a figure as seen in the view.
void stroke(Strokes& strokes, const Figure& figure, const Viewport& view, const Style& style);

}  // namespace touchstone::report
