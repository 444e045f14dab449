// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "catalogue/drawing.h"
#include "report/space_scale.h"

/// A scene in space as strokes between points in whole steps (space_scale.h): 5e-324 and 1e308 in one scene neither
/// vanish nor overflow, and whoever turns it goes on in doubles.
namespace touchstone::audit {

/// What one stroke of the pen draws.
struct SpaceItem {
  enum class Kind { face, edge, arrow, ball, dot, ring };
  Kind kind = Kind::dot;
  std::string style;  ///< class of the style sheet: q0 ... q3 by part of the question, truth, said, aid
  /// face: its corners; edge: its two ends, then its faces, counted among the items that are faces; arrow: start,
  /// tip; ball: centre, radius in steps; dot: place, radius in tenths of a pixel; ring: place.
  std::vector<int> numbers;
};

/// A text that wants to stand beside one of several points, or round the ball about its one point.
struct SpaceLabel {
  std::string text, style;
  std::vector<int> places;
  int radius = 0;
};

struct SpaceModel {
  std::vector<SpacePoint> points;
  std::vector<SpaceItem> items;
  std::vector<SpaceLabel> labels;
  int reach = steps_of_box;  ///< no point is further from the middle, however the scene is turned
  SpaceScale scale;
  std::size_t left_out = 0;  ///< figures that were too many
};

/// No items where the scene has no figure in space whose numbers are finite.
SpaceModel space_model(const Drawing& scene);

}  // namespace touchstone::audit
