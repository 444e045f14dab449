// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulate/run.h"

namespace touchstone::simulate {

/// The first difference between the contacts of two runs, and the question that decided it.
struct Parting {
  std::uint64_t step;
  std::string first, second;  ///< names of the runs
  Touch touch;
  /// The same question to both, with the numbers of each: the first whose answers are different enumerators. If all
  /// enumerators agree, and only the order of two times differs, the last question about a time before that.
  Asked by_first, by_second;
};

/// The difference in the step from these states, with which the contacts of two runs diverged; nullopt if questions and
/// answers were the same.
std::optional<Parting> parting(std::uint64_t step, const Run& first, const State<double>& before_first,
                               const Run& second, const State<double>& before_second);

/// "ball and floor".
std::string name_of(const Scene& scene, const Touch& touch);

}  // namespace touchstone::simulate
