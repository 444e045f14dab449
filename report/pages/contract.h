// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "catalogue/operation/operation.h"
#include "report/uses.h"

namespace touchstone::report {

/// The paragraphs of the comment above the operation's declaration in reference/, as they stand there.
std::vector<std::string> contract_of(const std::string& operation);

/// Such a paragraph as HTML: what is indented in it are formulas, each on its line.
std::string paragraph(const std::string& text);

/// A contract's second paragraph: up to the sentence with its last formula, or its first sentence where it has none;
/// and what follows.
std::pair<std::string, std::string> formula_and_rest(const std::string& text);

/// "deck p. 22"; where no page of the deck asks it, where the deck teaches what it is made of.
std::string pages_in_words(const Operation& operation);

/// What the operation decides and by which formula; the rest of the contract is folded.
std::string contract_section(const Operation& operation);

}  // namespace touchstone::report
