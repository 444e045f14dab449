// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/maps/map_grid.h"
#include "report/maps/palette.h"
#include "report/maps/png.h"

namespace touchstone::report {

/// Answers that a map shows alike.
struct MapClass {
  Verdict verdict = Verdict::agree;
  std::string said;  ///< the enumerator of the answer, or the distance of a number; empty if the verdict is sufficient
  std::uint64_t count = 0;
  std::array<Look, 2> looks{};  ///< by Scheme
  const Look& look(Scheme scheme) const { return looks[static_cast<std::size_t>(scheme)]; }
};

struct FailureMap {
  MapGrid grid;
  int side = MapGrid::side;  ///< squares to the right and upwards, each with the answer to one question
  std::string subject;
  std::vector<MapClass> classes;  ///< by verdict, then the most frequent first
  std::vector<std::uint8_t>
      squares;  ///< the class of each, row by row from the top; classes.size(): outside the contract
  std::array<std::uint64_t, verdict_count> counts{};
  std::uint64_t refused = 0;  ///< squares outside the contract

  std::uint64_t findings() const;
};

/// Maps over the same grid (failing_grid): the formula in double (or float), then robust, then the engine if there is
/// one. The same whatever the jobs. Empty if it was abandoned.
std::vector<FailureMap> failure_maps(const Operation& operation, int jobs, bool binary32 = false,
                                     Engine* engine = nullptr, const std::vector<Question>& candidates = {},
                                     const MapEffort& effort = {});

/// The map of the engine if there is one, otherwise that of the formula.
const FailureMap& subject_of(const std::vector<FailureMap>& maps);

/// One pixel for each point of the grid. Half of a palette index (rounded down) is the class, the same in both schemes.
Image image_of(const FailureMap& map, Scheme scheme = Scheme::light);
/// A small patch of that class, for a legend.
Image sample_of(const MapClass& entry, Scheme scheme);

/// The images side by side, `gap` pixels of white between them.
Image side_by_side(const std::vector<FailureMap>& maps, std::uint32_t gap);

/// "formulas in double: 12,345 of 65,536 wrong: 12,345 by rounding; robust: 0 of 65,536 wrong"
std::string in_words(const std::vector<FailureMap>& maps);

}  // namespace touchstone::report
