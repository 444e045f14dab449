// SPDX-License-Identifier: Apache-2.0
#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests {
namespace {

using audit::Verdict;

std::string complaint(const Operation& operation, const Question& question) {
  try {
    const auto examination = operation.examine(question);
    const std::string broken = examination->broken_promise();
    if (!broken.empty()) return broken;
    // Of numbers that a checker refuses, as slabs that lose a point, no comparison tells.
    const bool numbers_refused =
        operation.row().fault != nullptr && !operation.row().reference(question).numbers.empty();
    if (examination->judge_reference().verdict == Verdict::rounding && !examination->doubtful() && !numbers_refused) {
      return "the reference is wrong by rounding where rounding cannot have changed its decision";
    }
  } catch (const InvalidInput&) {
    // Refused: nothing is promised.
  }
  return "";
}

}  // namespace

EACH_OPERATION("the slide's formula in double keeps what its contract promises") {
  never(
      operation, "the reference keeps its promise",
      [&](const Question& question) { return complaint(operation, question); }, 8);
}

}  // namespace touchstone::proptests
