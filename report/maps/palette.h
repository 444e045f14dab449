// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "catalogue/judge/verdict.h"
#include "report/maps/png.h"

/// The colours of verdicts and answers, the same in bars, tables and maps. Findings are strong colours and differ in
/// lightness as well as in hue, so that they are distinguishable without colour vision and in print; right answers are
/// pale.
namespace touchstone::report {

enum class Scheme { light, dark };

Colour colour_of(Verdict verdict, Scheme scheme = Scheme::light);
/// For findings by rounding that underflow or overflow causes.
Colour range_colour(Scheme scheme = Scheme::light);
/// For places without a question: outside the contract, and between maps.
Colour blank_colour(Scheme scheme = Scheme::light);

/// The rank of an answer among an operation's answers: the most frequent truth is 0. A rare one may be a line one pixel
/// wide, where no pattern would be visible.
struct Rank {
  std::size_t place = 0;
  bool rare = false;
};

/// The look of an area of a map: the colour gives the verdict, the pattern the answer.
struct Look {
  enum class Pattern { plain, hatch, counter_hatch, dots, bars };
  Colour ground, mark;
  Pattern pattern = Pattern::plain;
  bool marked(std::size_t column, std::size_t row) const;  ///< true if that pixel has the mark's colour
};

Look look_of(Verdict verdict, const Rank& rank, Scheme scheme);

/// For a number that is too far off, by the lost decimal digits of the format: a scale of distance_levels steps from
/// yellow to violet. The last is for numbers without a correct digit.
constexpr std::size_t distance_levels = 7;
/// Distances that rounding does not explain are hatched in their verdict's colour.
Look look_of_distance(std::size_t level, Verdict verdict, Scheme scheme);

/// "#rrggbb"
std::string hex_of(const Colour& colour);

}  // namespace touchstone::report
