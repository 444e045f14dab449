// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/runs.h"

#include <algorithm>

namespace touchstone::audit::reducing {

bool drop_runs(Search& search, const Sequence& sequence) {
  bool better = false, any_within = false;
  std::size_t length = sequence.length(), run = length;
  for (int level = 0; length > 0 && !search.over(); ++level) {
    for (std::size_t at = 0; at < length;) {
      const auto found = search.first((length - at + run - 1) / run, [&](std::size_t i) {
        const std::size_t first = at + i * run;
        return sequence.without(first, std::min(first + run, length));
      });
      any_within = any_within || search.any_within();
      if (!found) break;
      better = true;
      at += *found * run;
      length = sequence.length();
    }
    constexpr int quarters = 2;
    if (run <= sequence.least || (sequence.give_up && !any_within && level == quarters)) break;
    run = std::min((run + 1) / 2, std::max<std::size_t>(length, 1));
  }
  return better;
}

}  // namespace touchstone::audit::reducing
