// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/repeat.h"

namespace touchstone::audit {

std::string repeat_command(const Operation& operation, const Question& question, const Repeat& repeat, bool foreign) {
  return "echo '" + one_line(operation.print(question)) + "' | " + (foreign ? repeat.program : Repeat{}.program) +
         " ask " + operation.name() + (foreign && !repeat.options.empty() ? " " + repeat.options : " -");
}

std::string repeat_command(const Operation& operation, const Question& question, const Tally& tally, bool of_robust) {
  const bool ours = tally.declaration.engine.empty() || tally.declaration.engine == "reference";
  return repeat_command(operation, question, tally.repeat, !of_robust && !ours);
}

}  // namespace touchstone::audit
