// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/figures/labels.h"
#include "report/words/wording.h"

/// Parts shared by several pages of the report. Arguments are plain text, results are HTML.
namespace touchstone::report {

/// The beginning of a failure map's element: pages that have one include its script (map.js).
inline constexpr const char* map_opening = "<div class=\"mapped\" data-map=\"";

/// The beginning of a player's element: its page includes viewer.js and player.js.
inline constexpr const char* player_opening = "<div class=\"player\" data-player=\"";

/// A complete page. `body` is HTML.
std::string page(const std::string& title, const std::string& body);

std::string code(const std::string& text);
/// Text between backquotes becomes code.
std::string words_in_html(const std::string& text);
/// The name of a verdict with its colour.
std::string badge(Verdict verdict, Speaker speaker);
std::string swatch(const std::string& colour);

/// One of our names, such as "point_on_segment": a line may break after each part of it.
std::string breakable(const std::string& name);
/// A shell command; it may break after a comma.
std::string shell_line(const std::string& line);

/// Shares of the verdicts as one horizontal bar, rounding in its two parts, with numbers for screen readers.
std::string verdict_bar(const Cell& cell, bool thin);

/// A kind of number in tables: "wrong", "cancellation" ...
struct Column {
  const char* name;
  bool found;  ///< its numbers are findings
  std::uint64_t (*count)(const Cell&);
};
/// The columns that are not 0 in `total`, and always cases and wrong. Cancellation, over- or underflow, algorithm and
/// invalid add up to wrong; wrong and the columns after those to the cases.
std::vector<Column> columns_of(const Cell& total);
std::string headings(const std::vector<Column>& columns);
std::string numbers(const std::vector<Column>& columns, const Cell& cell);

}  // namespace touchstone::report
