// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "audit/engines/engine.h"
#include "report/uses.h"

namespace touchstone::report {

/// The effort allowed for a failure map.
struct MapEffort {
  int side = 256;  ///< squares to the right and upwards: a power of two, at most that of the grid
  /// Called from time to time while the map is made; false abandons it.
  std::function<bool()> go_on{};

  /// A map has no more squares than the audit asked questions of the operation, `cases`: from 16 x 16 to 256 x 256.
  static MapEffort of(std::uint64_t cases);
  bool abandoned() const { return go_on && !go_on(); }
};

/// The questions of a failure map: a question with two of its numbers moved by -128 ... 127 steps. A step is the
/// distance from the number's magnitude to the next greater double, the same over the entire map; 0 has the step of the
/// greatest number.
struct MapGrid {
  static constexpr int side = 256;
  Question centre;
  std::pair<std::size_t, std::size_t> axes;  ///< the numbers that vary: to the right, upwards
  std::pair<double, double> step;
  std::pair<std::string, std::string> fields;  ///< "p[0]", "p[1]"
  Question at(int column, int row) const;      ///< row 0 is the top
};

/// The column of the grid that represents a square of a map of `side` squares a side, and the row. The middle of the
/// grid is one of them; the others vary within their squares, so that no stripe of a power of two is overlooked.
int column_of(int square, int side);
int row_of(int square, int side);

/// Around the operation's own degenerate question.
MapGrid map_grid(const Operation& operation, bool binary32 = false);
/// Around any question.
MapGrid map_grid(const Operation& operation, Question centre, std::pair<std::size_t, std::size_t> axes, bool binary32);

/// The operation's own grid if the engine (nullptr: the textbook formula) fails on it and is also right somewhere;
/// otherwise one around the first question that shows enough of both, among `candidates` and then questions drawn with
/// a fixed seed on which the formula fails. A wrong decision counts more than an inexact number. The operation's own
/// again if nothing better is found. Asks at most four times as many questions for it as the map itself.
MapGrid failing_grid(const Operation& operation, bool binary32 = false, Engine* engine = nullptr,
                     const std::vector<Question>& candidates = {}, const MapEffort& effort = {});

}  // namespace touchstone::report
