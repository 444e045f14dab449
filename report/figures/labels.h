// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/figures/viewport.h"

namespace touchstone::report {

/// A label that may stand next to one of several places.
struct LabelWish {
  std::vector<Pixel> places;
  std::string text, style;
};

/// The texts as SVG, each at the position where it covers least of the drawing and no other text; a text without room
/// is left out.
std::string placed_labels(const std::vector<LabelWish>& wishes, std::vector<Pixel> drawn, const Frame& frame);

/// For text and attribute values of HTML and SVG.
std::string escaped(const std::string& text);

}  // namespace touchstone::report
