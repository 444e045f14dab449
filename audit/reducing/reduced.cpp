// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/reduced.h"

#include "audit/reducing/passes.h"

namespace touchstone::audit {

Reduced reduced(const Operation& operation, const Question& question, Interest& interest,
                const SearchOptions& options) {
  Search search(operation, question, interest, options);
  std::uint64_t rounds = 0;
  for (bool better = true; better && !search.over(); ++rounds) {
    better = false;
    // Passes whose cost depends on the number of elements wait until there are few.
    for (bool dropped = true; dropped && !search.over();) {
      dropped = reducing::reduce_meshes(search);
      dropped = reducing::drop_elements(search) || dropped;
      better = better || dropped;
    }
    better = reducing::reduce_frame(search) || better;
    better = reducing::shorten_numbers(search) || better;
  }
  return {search.best(), search.candidates(), rounds, !search.over()};
}

}  // namespace touchstone::audit
