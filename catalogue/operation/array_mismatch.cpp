// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/array_mismatch.h"

#include <algorithm>

#include "catalogue/judge/environment.h"

namespace touchstone::catalogue {

std::string array_mismatch(const Operation& operation, const Question& question, Word decision,
                           std::size_t environment, std::uint64_t choice) {
  using robust::batch::Column;
  using robust::batch::Instructions;
  const ArrayFunctions& arrays = operation.row().batch;
  if (arrays.decide == nullptr) return "";
  std::vector<Column> columns;
  for (const std::size_t at : arrays.columns(question)) columns.emplace_back(&question.numbers[at], 0);
  std::vector<std::uint8_t> answers(1 + choice % 70);
  const auto at_most = static_cast<Instructions>(choice / 70 % 3);
  {
    const Environment set(environment);
    arrays.decide(question, columns.data(), answers.size(), answers.data(), at_most);
  }
  const auto other = [&](std::uint8_t answer) { return answer != decision; };
  const auto found = std::find_if(answers.begin(), answers.end(), other);
  if (found == answers.end()) return "";
  return "over arrays row " + std::to_string(found - answers.begin()) + " is answered " + std::to_string(*found) +
         " instead of " + std::to_string(decision) + ", with at most instruction set " +
         std::to_string(static_cast<int>(at_most));
}

}  // namespace touchstone::catalogue
