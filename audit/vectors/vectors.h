// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The number of questions drawn for each family, some of which are kept.
inline constexpr std::uint64_t drawn_of_a_family = 600;

/// The test vectors of one operation, one per line: at most two dozen a family, covering every outcome and every
/// failure of the textbook formula. The same seed gives the same bytes on every machine. The id of a line is its
/// operation and the first ten digits of the SHA-256 of its input, so that it names the same question in every version.
struct Vectors {
  std::vector<std::string> lines;
  std::size_t left_out = 0;  ///< longer than the operation's longest vector (Metadata::longest_vector)
};
Vectors vectors_of(const Operation& operation, std::uint64_t seed);

/// Vectors of these questions, in the family `recorded`.
std::vector<std::string> vectors_of(const Operation& operation, const std::vector<Question>& questions);

/// The reason why a line of vectors is refused: its certificate does not prove its truth, the oracle's truth differs,
/// robust disagrees, or a mesh that it names differs from the catalogue's of that name. "" if there is none. `folder`
/// contains the file of the line.
std::string vector_complaint(const std::string& line, const std::string& folder);

/// The part that concerns robust alone: differing answers, in any floating-point environment or over arrays.
std::string robust_complaint(const std::string& line, const std::string& folder);

}  // namespace touchstone::audit
