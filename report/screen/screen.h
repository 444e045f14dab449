// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"
#include "report/words/ways.h"

namespace touchstone::report {

/// So many lines fit on a screen.
inline constexpr std::size_t screen_lines = 60;

/// An audit on one screen: a row with a bar for each operation, the worst first, then the most telling findings in
/// words, each of another operation, then the closing sentence and `more`, a line or two on how to see the rest. What
/// has no room is counted. The same tally gives the same bytes.
/// `width` columns are as many as a question or an answer takes before it is cut; 0: none is.
std::string screen(const Tally& tally, const std::string& more, std::size_t width = line_width);

}  // namespace touchstone::report
