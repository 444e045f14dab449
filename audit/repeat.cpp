// SPDX-License-Identifier: Apache-2.0
#include "audit/repeat.h"

namespace touchstone::audit {

std::string repeat_command(const Operation& operation, const Question& question, const Tally& tally, bool of_robust) {
  const bool ours = of_robust || tally.declaration.engine.empty() || tally.declaration.engine == "reference";
  return "echo '" + one_line(operation.print(question)) + "' | touchstone ask " + operation.name() +
         (ours ? " -" : " --engine CMD");
}

}  // namespace touchstone::audit
