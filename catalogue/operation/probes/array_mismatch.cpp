// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/array_mismatch.h"

#include <algorithm>

#include "catalogue/judge/environment.h"

namespace touchstone::catalogue {
namespace {

using robust::batch::Column;
using robust::batch::Instructions;

/// The answers of each row, or which of them is wrong.
struct Answered {
  std::vector<std::uint8_t> answers;
  Instructions at_most;
  std::string refusal;

  Answered(const Operation& operation, const Question& question, std::size_t environment, std::uint64_t choice)
      : answers(1 + choice % 70), at_most(static_cast<Instructions>(choice / 70 % 3)) {
    const ArrayFunctions& arrays = operation.row().batch;
    std::vector<Column> columns;
    for (const std::size_t at : arrays.columns(question)) columns.emplace_back(&question.numbers[at], 0);
    const Environment set(environment);
    try {
      arrays.decide(question, columns.data(), answers.size(), answers.data(), at_most);
    } catch (const InvalidInput& refused) {
      refusal = refused.what();
    }
  }

  std::string with_set(const std::string& complaint) const {
    return "over arrays " + complaint + ", with at most instruction set " + std::to_string(static_cast<int>(at_most));
  }
};

/// The refusal of the shared part of all rows, which is checked before any row; "" if it is not refused, or if nothing
/// is shared.
std::string refusal_of_shared(const Operation& operation, Question question, std::size_t environment) {
  const ArrayFunctions& arrays = operation.row().batch;
  const Question zeros = operation.zeros_of_alternatives().front();
  if (arrays.columns(zeros).size() == zeros.numbers.size()) return "";
  for (const std::size_t at : arrays.columns(question)) question.numbers[at] = 1;  // a direction may not be 0
  try {
    operation.row().robust(question, environment);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace

std::string array_mismatch(const Operation& operation, const Question& question, Word decision, std::size_t environment,
                           std::uint64_t choice) {
  if (operation.row().batch.decide == nullptr) return "";
  const Answered answered(operation, question, environment, choice);
  if (!answered.refusal.empty()) return answered.with_set("it is refused: " + answered.refusal);
  const auto other = [&](std::uint8_t answer) { return answer != decision; };
  const auto found = std::find_if(answered.answers.begin(), answered.answers.end(), other);
  if (found == answered.answers.end()) return "";
  return answered.with_set("row " + std::to_string(found - answered.answers.begin()) + " is answered " +
                           std::to_string(*found) + " instead of " + std::to_string(decision));
}

std::string array_refusal_mismatch(const Operation& operation, const Question& question, const std::string& refusal,
                                   std::size_t environment, std::uint64_t choice) {
  if (operation.row().batch.decide == nullptr) return "";
  const std::string of_shared = refusal_of_shared(operation, question, environment);
  const std::string expected = of_shared.empty() ? "questions[0]." + refusal : of_shared;
  const Answered answered(operation, question, environment, choice);
  if (answered.refusal == expected) return "";
  return answered.with_set("it says \"" + answered.refusal + "\" instead of \"" + expected + "\"");
}

}  // namespace touchstone::catalogue
