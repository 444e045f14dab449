// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "audit/time_limit.h"

namespace touchstone::audit {

/// The engine whose answers were counted, and how the cases were drawn.
struct Shrinking {
  const Operation& operation;
  std::uint64_t seed = 1;
  Limits limits = {};
  const TimeLimit& limit;    ///< after it expires, examples stay unchanged
  Engine* engine = nullptr;  ///< nullptr: our own formula, or robust
  bool robust = false;
  int jobs = 1;
  std::uint64_t effort;  ///< the effort allowed, from effort_to_shrink
  std::function<void(std::size_t, std::size_t)>
      progress{};  ///< called with the number shrunk and the total; from any thread
};

/// The effort for shrinking the findings of an operation, given the number of its cases: in units of Metadata::cost, so
/// that it is the same on every machine.
std::uint64_t effort_to_shrink(const Operation& operation, std::uint64_t cases);

/// Shrinks the examples of an operation on their draw streams. An example keeps its family and its outcome, and stays
/// as ordinary as it was, with no more degenerate features. For each outcome the example of the family with the best
/// one is shrunk, then those of the next three, as far as the effort goes; the others stay as drawn. The cost of a
/// question is relative to the usual length: small ones continue cheaply. `families`: the number of each family of the
/// tally within the operation. The same whatever `jobs` is.
void shrink_examples(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally);

}  // namespace touchstone::audit
