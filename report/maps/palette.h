// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "catalogue/judge/verdict.h"
#include "report/maps/png.h"

/// The colours of verdicts and answers, the same in bars, tables and maps. Findings are strong colours and differ in
/// lightness as well as in hue, so that they differ without colour vision and in print; what is right is pale.
namespace touchstone::report {

enum class Scheme { light, dark };

Colour colour_of(Verdict verdict, Scheme scheme = Scheme::light);
/// Of findings by rounding, those that underflow or overflow is to blame for.
Colour range_colour(Scheme scheme = Scheme::light);
/// Where there is no question: outside the contract, and between maps.
Colour blank_colour(Scheme scheme = Scheme::light);

/// Which of the answers that an operation has: the commonest truth is 0. A rare one may be a line one pixel wide, where
/// no pattern would be seen.
struct Rank {
  std::size_t place = 0;
  bool rare = false;
};

/// How an area of a map looks: the colour says the verdict, the pattern which answer it is.
struct Look {
  enum class Pattern { plain, hatch, counter_hatch, dots, bars };
  Colour ground, mark;
  Pattern pattern = Pattern::plain;
  bool marked(std::size_t column, std::size_t row) const;  ///< whether that pixel has the mark's colour
};

Look look_of(Verdict verdict, const Rank& rank, Scheme scheme);

/// Of a number that is too far off, by how many decimal digits of the format were lost: a scale of distance_levels
/// steps from yellow to violet. The last is for numbers without a correct digit.
constexpr std::size_t distance_levels = 7;
/// What rounding does not explain is hatched in its verdict's colour.
Look look_of_distance(std::size_t level, Verdict verdict, Scheme scheme);

/// "#rrggbb"
std::string hex_of(const Colour& colour);

}  // namespace touchstone::report
