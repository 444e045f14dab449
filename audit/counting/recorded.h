// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchstone::audit {

/// The distance of the textbook formula from another course on a recorded call, in units of its own rounding
/// (Tracked::nearest_comparison): classes below these bounds, and one from the last bound on. The first class is ties:
/// two numbers that the formula compares are equal.
inline constexpr std::array<double, 7> nearness_bounds{0x1p-1074, 1, 10, 100, 1e4, 1e6, 1e9};
inline constexpr std::size_t nearness_classes = nearness_bounds.size() + 1;
inline constexpr std::array<const char*, nearness_classes> nearness_names{"tie", "1",   "10",  "100",
                                                                          "1e4", "1e6", "1e9", "more"};

/// The counts of recorded calls besides their verdicts.
struct Recorded {
  std::array<std::uint64_t, nearness_classes> nearness{};
  /// Calls on which the textbook formula decides otherwise than the truth, in double and in float; and calls that are
  /// decided differently for open sets than for closed ones.
  std::uint64_t in_double = 0, in_float = 0, as_open_sets = 0;

  std::uint64_t calls() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : nearness) sum += n;
    return sum;
  }
  void add_nearness(double nearest) {
    std::size_t c = 0;
    while (c < nearness_bounds.size() && !(nearest < nearness_bounds[c])) ++c;
    ++nearness[c];
  }
  void merge(const Recorded& other) {
    for (std::size_t c = 0; c < nearness_classes; ++c) nearness[c] += other.nearness[c];
    in_double += other.in_double;
    in_float += other.in_float;
    as_open_sets += other.as_open_sets;
  }
};

}  // namespace touchstone::audit
