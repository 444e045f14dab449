// SPDX-License-Identifier: Apache-2.0
#include "proptests/laws.h"

namespace touchstone::proptests {
namespace {

std::string refusal(const auto& ask) {
  try {
    ask();
    return "answered";
  } catch (const InvalidInput& thrown) {
    return thrown.field() + ": " + thrown.rule();
  }
}

}  // namespace

void example(const Operation& operation, const Question& question, const catalogue::EncodedTruth& expected,
             const std::string& by_reference) {
  using catalogue::Reading;
  INFO(catalogue::one_line(operation.print(question)));
  const catalogue::Shape& shape = operation.answer_shape();
  const catalogue::RowFunctions& row = operation.row();
  const auto examination = operation.examine(question);
  CHECK(catalogue::one_line(examination->truth()) == catalogue::one_line(operation.answer_json(expected)));
  const catalogue::Comparison robust = catalogue::compared(shape, expected, row.robust(question, 0), Reading::complete);
  CHECK(robust.decision);
  CHECK(robust.ulps == 0);
  CHECK(name_of(examination->judge_reference().verdict) == by_reference);
  if (by_reference != "agree") return;
  const Reading reading = operation.metadata().formula_answers_less ? Reading::less : Reading::complete;
  const catalogue::Comparison reference = catalogue::compared(shape, expected, row.reference(question), reading);
  CHECK(reference.decision);
  CHECK(reference.ulps <= operation.metadata().ulps);
}

void refused(const Operation& operation, const Question& question, const std::string& expected) {
  CHECK(refusal([&] { operation.row().robust(question, 0); }) == expected);
  CHECK(refusal([&] { operation.row().solve(question); }) == expected);
}

}  // namespace touchstone::proptests
