// SPDX-License-Identifier: Apache-2.0
#include "catalogue/symmetries.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

// The symmetries that rows declare (catalogue/laws.h), asked of robust and of the oracle.
namespace touchstone::proptests {

EACH_OPERATION("the symmetries that its row declares hold for robust") {
  if (!audit::declares_laws(operation)) return;
  const audit::Answering<double> robust = [&](const Question& q) { return operation.row().robust(q, 0); };
  never(
      operation, "robust: symmetries",
      [&](const Question& question) {
        return audit::broken_law(operation, question, robust, operation.answer_shape(), audit::Compared::everything);
      },
      12);
}

EACH_OPERATION("the symmetries that its row declares hold for the oracle") {
  if (!audit::declares_laws(operation)) return;
  const audit::Answering<audit::TrueNumber> oracle = [&](const Question& q) { return operation.row().solve(q).answer; };
  never(
      operation, "oracle: symmetries",
      [&](const Question& question) { return audit::broken_law(operation, question, oracle); }, 1);
}

}  // namespace touchstone::proptests
