// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulate/run.h"

namespace touchstone::simulate {

/// Where two runs answered different contacts for the first time, and what decided it.
struct Parting {
  std::uint64_t step;
  std::string first, second;  ///< names of the runs
  Touch touch;
  /// The same question to both, by the numbers of each: the first whose answers are different words. Where all words
  /// are alike, and only the order of two times is not, the last question about a time before that.
  Asked by_first, by_second;
};

/// Of the step from these states, with which the contacts of two runs came apart; empty where they asked the same and
/// were answered the same.
std::optional<Parting> parting(std::uint64_t step, const Run& first, const State<double>& before_first,
                               const Run& second, const State<double>& before_second);

/// "ball and floor".
std::string name_of(const Scene& scene, const Touch& touch);

}  // namespace touchstone::simulate
