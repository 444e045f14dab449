// SPDX-License-Identifier: Apache-2.0
#include "catalogue/judge/examination_of.h"
#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests {
namespace {

using audit::Verdict;

/// Whether rounding may have changed the course of the slide's formula, by running error analysis.
template <class Row>
bool doubtful(const Question& question) {
  using Bounded = audit::Tracked<double>;
  Bounded::doubtful() = false;
  audit::ask_reference<Row>(
      audit::converted<Bounded>(typed<Row>(question), [](double number) { return Bounded(number); }));
  return Bounded::doubtful();
}

bool doubtful(const Operation& operation, const Question& question) {
  bool doubt = false;
  audit::for_each_row([&]<class Row>() {
    if (&Row::card() == &operation.card()) doubt = doubtful<Row>(question);
  });
  return doubt;
}

std::string complaint(const Operation& operation, const Question& question) {
  try {
    const auto examination = operation.examine(question);
    const std::string broken = examination->broken_promise();
    if (!broken.empty()) return broken;
    if (examination->judge_reference().verdict == Verdict::rounding && !doubtful(operation, question)) {
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
