// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "audit/engines/engine.h"
#include "report/png.h"

namespace touchstone::audit {

/// The questions of a failure map: a degenerate question, two of its numbers moved by -128 ... 127 steps. A step is the
/// distance from the number's size to the next greater one, the same over the whole map.
struct MapGrid {
  static constexpr int side = 256;
  Question centre;
  std::pair<std::size_t, std::size_t> axes;  ///< which numbers move: to the right, upwards
  std::pair<double, double> step;
  std::pair<std::string, std::string> fields;  ///< "p[0]", "p[1]"
  Question at(int column, int row) const;      ///< row 0 is the top
};
MapGrid map_grid(const Operation& operation, bool binary32 = false);

/// Answers that a map shows in one colour.
struct MapClass {
  Verdict verdict = Verdict::agree;
  std::string said;  ///< the word of the answer, or how far a number is off; empty where the verdict says all
  std::uint64_t count = 0;
  Colour colour{};
};

struct FailureMap {
  std::string subject;
  Image image;
  std::vector<MapClass> classes;  ///< by verdict, then the commonest first
  std::array<std::uint64_t, verdict_count> counts{};
  std::uint64_t refused = 0;  ///< pixels outside the contract
};

/// Maps over the same grid: reference in double (or float), then robust, then the engine if there is one. The same
/// whatever the jobs.
std::vector<FailureMap> failure_maps(const Operation& operation, int jobs, bool binary32 = false,
                                     Engine* engine = nullptr);

/// The images side by side, `gap` pixels of white between them.
Image side_by_side(const std::vector<FailureMap>& maps, std::uint32_t gap);

/// "reference (binary64): 12,345 of 65,536 wrong: 12,345 by rounding; robust: 0 of 65,536 wrong"
std::string in_words(const std::vector<FailureMap>& maps);

}  // namespace touchstone::audit
