// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "audit/engines/engine.h"
#include "audit/tally.h"
#include "audit/time_limit.h"

namespace touchstone::audit {

/// Whose answers were counted, and how the cases were drawn.
struct Shrinking {
  const Operation& operation;
  std::uint64_t seed = 1;
  Limits limits = {};
  const TimeLimit& limit;    ///< when it is over, examples stay as they are
  Engine* engine = nullptr;  ///< nullptr: our own formula, or robust
  bool robust = false;
  int jobs = 1;
};

/// Makes the examples of an operation smaller on their draw streams. An example keeps its family and its way of
/// answering, and stays as ordinary and as generic as it was. Of each way those of the four families with the best
/// examples are made smaller, and the others stay as drawn; what is shown of a way comes from these. `families`: the
/// number of each family of the tally within the operation. The same whatever `jobs` is.
void shrink_examples(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally);

}  // namespace touchstone::audit
