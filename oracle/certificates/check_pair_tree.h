// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// The claim that `pairs` are all pairs of boxes that meet.
struct PairTreeClaim {
  std::span<const double> boxes;         ///< six for each box: min, max
  std::span<const std::uint32_t> pairs;  ///< two for each pair
  std::span<const std::uint32_t> order, cuts;
  std::span<const std::uint8_t> steps;
};

/// Throws Refusal if that is not proved. The time is linear in the input.
void check_pair_tree(const PairTreeClaim& claim);

/// The same for a claim about `all_pairs` whose certificate is of the kind `tree`; its lists are packed.
void check_pair_tree(const Claim& claim);

}  // namespace touchstone::certify
