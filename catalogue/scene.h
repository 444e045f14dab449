// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace touchstone::audit {

/// A figure in the coordinates of the input, before anyone decides on pixels.
struct Figure {
  enum class Kind { point, segment, line, ray, circle, arrow, polygon };
  Kind kind = Kind::point;
  std::string label;  ///< field name of the input ("a", "segment") or of the answer; a line drawn to help has none
  /// point x y; segment, line, ray, arrow x y x y (ray and line: two points on it); circle x y r; polygon x y x y ...
  std::vector<double> numbers;
  bool answer = false;  ///< belongs to the truth, not to the question
  bool said = false;    ///< is what an implementation answered, right or wrong
};

struct Scene {
  std::vector<Figure> figures;
  std::vector<std::string> notes;  ///< what cannot be drawn, in words
};

}  // namespace touchstone::audit
