// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// The number of outcomes of an operation that are shown with an example.
inline constexpr std::size_t most_outcomes = 6;

/// An outcome of an operation, over all its families.
struct OperationOutcome {
  JudgedOutcome outcome;
  OutcomeCount counted;
  std::string family;  ///< of the example
  /// The number of cases with this outcome in each family, and the family's total: those with the most cases, at most
  /// three.
  struct OfFamily {
    std::string name;
    std::uint64_t cases, of;
  };
  std::vector<OfFamily> families{};
};
/// "many_moves 26 of 37, grid 2 of 37": as many as fit, the first in any case.
std::string families_in_words(const OperationOutcome& outcome, std::size_t room);

/// "inside where the truth is boundary, "; empty if the enumerators are the same, or missing.
std::string answer_in_words(const JudgedOutcome& outcome);

/// Columns of a line of text.
inline constexpr std::size_t line_width = 120;
/// Prose wrapped so that it fits next to a key of `indent` columns.
std::string wrapped(const std::string& prose, std::size_t indent);

/// The outcomes that have an example: wrong answers, then inexact ones, then those that are not findings; among these
/// the most frequent at ordinary magnitude first.
std::vector<OperationOutcome> outcomes_of(const OperationTally& tally);

}  // namespace touchstone::report
