// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"
#include "report/labels.h"
#include "report/wording.h"

/// Pieces that several pages of the report are made of. Arguments are plain text, results are HTML.
namespace touchstone::audit {

/// A whole page. `body` is HTML.
std::string page(const std::string& title, const std::string& body);

std::string code(const std::string& text);
/// The name of a verdict with its colour.
std::string badge(Verdict verdict, Speaker speaker);
std::string swatch(const std::string& colour);

/// Shares of the verdicts as one horizontal bar, its numbers said to screen readers.
std::string verdict_bar(const Cell& cell, bool thin);
/// The findings alone, as parts of all findings. Empty where there is none.
std::string cause_bar(const Cell& cell);

/// Numbers of a cell as table cells, in the order of verdict_columns.
std::string verdict_columns();
std::string verdict_numbers(const Cell& cell);

}  // namespace touchstone::audit
