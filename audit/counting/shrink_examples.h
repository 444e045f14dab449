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

/// Whose answers were counted, and how the cases were drawn.
struct Shrinking {
  const Operation& operation;
  std::uint64_t seed = 1;
  Limits limits = {};
  const TimeLimit& limit;    ///< when it is over, examples stay as they are
  Engine* engine = nullptr;  ///< nullptr: our own formula, or robust
  bool robust = false;
  int jobs = 1;
  std::uint64_t effort;  ///< what it may cost, from effort_to_shrink
  std::function<void(std::size_t, std::size_t)>
      progress{};  ///< hears how many are smaller, of how many; from any thread
};

/// What making the findings of an operation smaller may cost where so many cases of it are asked: in units of
/// Metadata::cost, so that it is the same on every machine.
std::uint64_t effort_to_shrink(const Operation& operation, std::uint64_t cases);

/// Makes the examples of an operation smaller on their draw streams. An example keeps its family and its way of
/// answering, and stays as ordinary as it was, with no more degenerate features. Of each way that of the family with
/// the best example is made smaller, then those of the next three, as far as the effort goes; the others stay as drawn.
/// A question counts for as much as its length is of the usual: what has become small goes on cheaply. `families`: the
/// number of each family of the tally within the operation. The same whatever `jobs` is.
void shrink_examples(const Shrinking& shrinking, const std::vector<std::size_t>& families, OperationTally& tally);

}  // namespace touchstone::audit
