// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/reducing/search.h"

namespace touchstone::audit {

struct Reduced {
  Question question;
  std::uint64_t candidates = 0;  ///< that were looked at
  std::uint64_t rounds = 0;
  bool finished = false;  ///< no pass makes it shorter; else the search was ended
};

/// The shortest question that holds, by all passes (audit/reducing/passes.h) in rounds until none makes it shorter.
/// What it finds does not depend on the jobs, unless it is ended early. `question`: one that holds.
Reduced reduced(const Operation& operation, const Question& question, Interest& interest, const SearchOptions& options);

}  // namespace touchstone::audit
