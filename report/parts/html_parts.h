// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/figures/labels.h"
#include "report/words/wording.h"

/// Pieces that several pages of the report are made of. Arguments are plain text, results are HTML.
namespace touchstone::report {

/// What a failure map's element begins with: pages that have one carry its script (map.js).
inline constexpr const char* map_opening = "<div class=\"mapped\" data-map=\"";

/// What a player's element begins with: its page carries viewer.js and player.js.
inline constexpr const char* player_opening = "<div class=\"player\" data-player=\"";

/// A complete page. `body` is HTML.
std::string page(const std::string& title, const std::string& body);

std::string code(const std::string& text);
/// Words between backquotes are code.
std::string words_in_html(const std::string& text);
/// The name of a verdict with its colour.
std::string badge(Verdict verdict, Speaker speaker);
std::string swatch(const std::string& colour);

/// A name of ours, as in "point_on_segment": a line may break after each part of it.
std::string breakable(const std::string& name);
/// A line for a shell; it may break after a comma.
std::string shell_line(const std::string& line);

/// Shares of the verdicts as one horizontal bar, rounding in its two parts, its numbers for screen readers.
std::string verdict_bar(const Cell& cell, bool thin);

/// A kind of number in tables: "wrong", "cancellation" ...
struct Column {
  const char* name;
  bool found;  ///< its numbers are findings
  std::uint64_t (*count)(const Cell&);
};
/// Those that are not 0 in `total`, cases and wrong always. Cancellation, over- or underflow, algorithm and invalid add
/// up to wrong; wrong and what follows them to the cases.
std::vector<Column> columns_of(const Cell& total);
std::string headings(const std::vector<Column>& columns);
std::string numbers(const std::vector<Column>& columns, const Cell& cell);

}  // namespace touchstone::report
