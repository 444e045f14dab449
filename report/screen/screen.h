// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"
#include "report/words/ways.h"

namespace touchstone::report {

/// The number of lines on a screen.
inline constexpr std::size_t screen_lines = 60;

/// An audit on one screen: a row with a bar for each operation, the worst first, then the highest-ranked findings in
/// words, each from another operation, then the closing sentence and `more`, a line or two on how to see the rest.
/// Entries that do not fit are counted. The same tally gives the same bytes.
/// `width`: the columns of a question or an answer before it is truncated; 0: no limit.
std::string screen(const Tally& tally, const std::string& more, std::size_t width = line_width);

}  // namespace touchstone::report
