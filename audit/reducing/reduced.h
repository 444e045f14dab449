// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/reducing/search.h"

namespace touchstone::audit {

struct Reduced {
  Question question;
  std::uint64_t candidates = 0;  ///< number examined
  std::uint64_t rounds = 0;
  bool finished = false;  ///< no pass makes it shorter; otherwise the search was ended
};

/// The shortest question with the property, by all passes (audit/reducing/passes.h) in rounds until none makes it
/// shorter. The result does not depend on the jobs, unless it is ended early. `question`: one with the property.
Reduced reduced(const Operation& operation, const Question& question, Interest& interest, const SearchOptions& options);

}  // namespace touchstone::audit
