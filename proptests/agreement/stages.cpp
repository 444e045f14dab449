// SPDX-License-Identifier: Apache-2.0
#include "proptests/any_robust_bits.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests {
namespace {

using audit::StageFunctions;
using audit::Tape;
using robust::Stage;

/// What is wrong with some stage of a valid question; the stage that decides is never later than the first that knows.
std::string disagreement(const StageFunctions& stages, const Question& question, std::size_t environment,
                         const Tape<double>& answer) {
  const Stage decided = stages.decided_by == nullptr ? Stage::filter : stages.decided_by(question, environment);
  for (const StageFunctions::One& one : stages.each) {
    const std::string name = "stage " + std::to_string(static_cast<int>(one.stage)) + ": ";
    const auto found = one.ask(question, environment);
    if (found && *found != answer) return name + "it is not the answer";
    if (found && decided > one.stage) return name + "it knows the answer, but a later one decided";
    if (!found && one.stage == Stage::exact) return name + "it must always know";
  }
  return "";
}

std::string complaint(const Operation& operation, const Question& question) {
  const audit::RowFunctions& row = operation.row();
  for (const std::size_t environment : {std::size_t{0}, environment_of(question)}) {
    std::string found;
    try {
      found = disagreement(row.stages, question, environment, row.robust(question, environment));
      if (found.empty() && row.decision != nullptr) {
        Tape<double> decision;
        decision.words = {row.decide(question, environment)};
        found = disagreement(row.decision_stages, question, environment, decision);
      }
    } catch (const InvalidInput&) {
      return "";
    }
    if (!found.empty()) return found + " (" + environment_name(environment) + ")";
  }
  return "";
}

}  // namespace

EACH_OPERATION("every stage that knows an answer gives the same, and the last one always knows") {
  if (operation.row().stages.each.empty()) return;
  never(
      operation, "stages", [&](const Question& question) { return complaint(operation, question); }, 12);
}

}  // namespace touchstone::proptests
