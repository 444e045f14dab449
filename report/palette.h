// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "catalogue/judge/verdict.h"
#include "report/png.h"

/// The colours of verdicts and answers, the same in bars, tables and maps. Verdicts differ in lightness as well as in
/// hue, so that they are told apart without colour vision and in print.
namespace touchstone::audit {

Colour colour_of(Verdict verdict);

/// For maps. A right answer has a light tint by the rank of its word (the commonest truth first; the third, often a
/// line one pixel wide, is dark). A wrong one has its verdict's colour, lighter or darker by the rank of the word that
/// it says.
Colour map_colour(Verdict verdict, std::size_t rank);

/// For maps of answers that are numbers alone: the further off, the darker. decade: of the distance in ulps, 0 for the
/// correctly rounded number, 8 for more than a million.
Colour distance_colour(Verdict verdict, std::size_t decade);

/// "#rrggbb"
std::string hex_of(const Colour& colour);

}  // namespace touchstone::audit
