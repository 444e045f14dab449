// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// That `pairs` are all pairs of boxes that meet.
struct PairTreeClaim {
  std::span<const double> boxes;         ///< six a box: min, max
  std::span<const std::uint32_t> pairs;  ///< two a pair
  std::span<const std::uint32_t> order, cuts;
  std::span<const std::uint8_t> steps;
};

/// Throws Refusal where that is not proved. Its time is linear in all that it reads.
void check_pair_tree(const PairTreeClaim& claim);

/// The same of a claim about `all_pairs` whose certificate is of the kind `tree`; its lists are packed.
void check_pair_tree(const Claim& claim);

}  // namespace touchstone::certify
