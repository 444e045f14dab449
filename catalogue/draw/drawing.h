// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::catalogue {

/// What a search did with a node of a structure over bodies.
struct Passed {
  int depth = 0;         ///< below the root, which has 0
  bool entered = false;  ///< the search went on to what is in it
};

/// A figure in the coordinates of the input, before anyone decides on pixels.
struct Figure {
  enum class Kind { point, segment, line, ray, circle, arrow, polygon };
  Kind kind = Kind::point;
  std::string label;  ///< field name of the input ("a", "segment") or of the answer; a line drawn to help has none
  /// point x y; segment, line, ray, arrow x y x y (ray and line: two points on it); circle x y r; polygon x y x y ...
  std::vector<double> numbers;
  bool answer = false;           ///< belongs to the truth, not to the question
  bool said = false;             ///< is what an implementation answered, right or wrong
  std::optional<Passed> node{};  ///< drawn to help: a node of a structure
};

/// How far from its place a figure is that moves, straight before t = 0 and straight after it.
struct Displacements {
  std::array<double, 3> at_minus_1{}, at_1{};
};

/// A figure in space, y up.
struct SpaceFigure {
  enum class Kind { point, segment, arrow, plane, polygon, box, sphere, mesh };
  Kind kind = Kind::point;
  std::string label;  ///< as of a Figure
  /// point x y z; segment, arrow x y z x y z; plane its normal and offset; polygon, mesh x y z x y z ...; box its
  /// least and greatest corner; sphere x y z r
  std::vector<double> numbers;
  /// Of a mesh: each the places of its corners in the list of points, counter-clockwise as seen from outside.
  std::vector<std::vector<std::uint32_t>> faces;
  bool answer = false;
  bool said = false;
  std::optional<Passed> node{};
  std::optional<Displacements> moves{};  ///< its place is that at t = 0
};

/// What is drawn of a question and its truth. A drawing with figures in the plane is shown in the plane: a row that
/// draws a side view of its own knows best. Else its figures in space are shown as a view that the reader turns.
struct Drawing {
  std::vector<Figure> figures;
  std::vector<SpaceFigure> space;
  std::vector<std::string> notes;  ///< what cannot be drawn, in words
  std::string search;              ///< of a search in a structure that is drawn: what it passed, counted, in words
};

}  // namespace touchstone::catalogue
