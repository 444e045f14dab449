// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace touchstone::catalogue {

/// The number of steps of a computation on a question whose lists have n elements, up to a constant factor.
enum class Growth { constant, linear, linearithmic, quadratic, quadratic_log, cubic, quartic };

/// "1", "n", "n log n" ...
std::string name_of(Growth growth);
/// At most 2^64 - 1.
std::uint64_t steps_of(Growth growth, std::uint64_t n);

/// The growth of the time for a question in general position: answers, and pairs of neighbours, no more than elements
/// of the lists. n counts the elements of all lists, including vertices and faces of meshes.
struct Time {
  Growth robust = Growth::constant;
  Growth oracle = Growth::constant;     ///< the truth and its margin
  Growth ask = Growth::constant;        ///< all that `ask` prints except the formula: its certificate and verdicts
  Growth reference = Growth::constant;  ///< the textbook formula
};
/// The same growth for all.
constexpr Time grows(Growth growth) { return {growth, growth, growth, growth}; }

}  // namespace touchstone::catalogue
