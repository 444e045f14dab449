// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::catalogue {

/// The action of a search at a node of a structure over bodies.
struct Passed {
  int depth = 0;         ///< below the root, which has depth 0
  bool entered = false;  ///< the search continued inside
};

/// A figure in the coordinates of the input, before any choice of pixels.
struct Figure {
  enum class Kind { point, segment, line, ray, circle, arrow, polygon };
  Kind kind = Kind::point;
  std::string label;  ///< field name of the input ("a", "segment") or of the answer; "" for an auxiliary line
  /// point x y; segment, line, ray, arrow x y x y (ray and line: two points on it); circle x y r; polygon x y x y ...
  std::vector<double> numbers;
  bool answer = false;           ///< belongs to the truth, not to the question
  bool said = false;             ///< an implementation's answer, right or wrong
  std::optional<Passed> node{};  ///< auxiliary: a node of a structure
};

/// The displacement of a moving figure from its position, straight before t = 0 and straight after it.
struct Displacements {
  std::array<double, 3> at_minus_1{}, at_1{};
};

/// A figure in space, y up.
struct SpaceFigure {
  enum class Kind { point, segment, arrow, plane, polygon, box, sphere, mesh };
  Kind kind = Kind::point;
  std::string label;  ///< as in Figure
  /// point x y z; segment, arrow x y z x y z; plane its normal and offset; polygon, mesh x y z x y z ...; box its least
  /// and greatest corner; sphere x y z r
  std::vector<double> numbers;
  /// For a mesh: the indices of each face's corners in the list of points, counter-clockwise as seen from outside.
  std::vector<std::vector<std::uint32_t>> faces;
  bool answer = false;
  bool said = false;
  std::optional<Passed> node{};
  std::optional<Displacements> moves{};  ///< its position is that at t = 0
};

/// The figures of a question and its truth. A drawing with figures in the plane is shown in the plane: a row that draws
/// its own side view takes precedence. Otherwise its figures in space are shown as a view that the reader can rotate.
struct Drawing {
  std::vector<Figure> figures;
  std::vector<SpaceFigure> space;
  std::vector<std::string> notes;  ///< parts that cannot be drawn, in words
  std::string search;              ///< for a search in a drawn structure: the count of nodes that it passed, in words
};

}  // namespace touchstone::catalogue
