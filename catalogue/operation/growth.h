// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace touchstone::catalogue {

/// How many steps a computation takes on a question whose lists have n elements, up to a constant factor.
enum class Growth { constant, linear, linearithmic, quadratic, quadratic_log, cubic, quartic };

/// "1", "n", "n log n" ...
std::string name_of(Growth growth);
/// At most 2^64 - 1.
std::uint64_t steps_of(Growth growth, std::uint64_t n);

/// How the time of a question grows that is in general position: answers, and pairs of what is near each other, no more
/// than elements of the lists. n counts the elements of all lists, vertices and faces of meshes too.
struct Time {
  Growth robust = Growth::constant;
  Growth oracle = Growth::constant;     ///< the truth and its margin
  Growth ask = Growth::constant;        ///< all that `ask` prints but the textbook formula: its certificate and judges
  Growth reference = Growth::constant;  ///< the textbook formula
};
/// All four of them.
constexpr Time grows(Growth growth) { return {growth, growth, growth, growth}; }

}  // namespace touchstone::catalogue
