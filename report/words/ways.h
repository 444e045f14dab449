// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Of an operation: so many are shown with an example.
inline constexpr std::size_t most_ways = 6;

/// A way of answering an operation, over all its families.
struct WayOfOperation {
  Way way;
  WayCount counted;
  std::string family;  ///< of the example
  /// How many cases of which family were answered so, of how many: those of most cases, three at most.
  struct OfFamily {
    std::string name;
    std::uint64_t cases, of;
  };
  std::vector<OfFamily> families{};
};
/// "many_moves 26 of 37, grid 2 of 37": as many as have room, the first in any case.
std::string families_in_words(const WayOfOperation& way, std::size_t room);

/// "inside where the truth is boundary, "; empty where the words are the same, or none.
std::string answer_in_words(const Way& way);

/// Columns of a line of text.
inline constexpr std::size_t line_width = 120;
/// Prose broken between words so that it fits next to a key of `indent` columns.
std::string wrapped(const std::string& prose, std::size_t indent);

/// Those that have an example: wrong answers, then inexact ones, then what is no finding; of these what is most
/// frequent at ordinary size first.
std::vector<WayOfOperation> ways_of(const OperationTally& tally);

}  // namespace touchstone::report
