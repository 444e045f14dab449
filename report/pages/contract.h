// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// The paragraphs of the comment above the operation's declaration in reference/, verbatim.
std::vector<std::string> contract_of(const std::string& operation);

/// Such a paragraph as HTML: its indented lines are formulas, each on its own line.
std::string paragraph(const std::string& text);

/// A contract's second paragraph: up to the sentence with its last formula, or its first sentence if it has none; and
/// the rest.
std::pair<std::string, std::string> formula_and_rest(const std::string& text);

/// "deck p. 22"; if no page of the deck asks it, the pages that teach its parts.
std::string pages_in_words(const Operation& operation);

/// The decision of the operation and its formula; the rest of the contract is folded.
std::string contract_section(const Operation& operation);

}  // namespace touchstone::report
