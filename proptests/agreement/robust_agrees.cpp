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
    const audit::Judgement judged = examination->judge_robust();
    if (judged.verdict != Verdict::agree) {
      return std::string("robust: ") + name_of(judged.verdict) + " " + judged.remark + ", it answers " +
             audit::one_line(examination->robust()) + ", the truth is " + audit::one_line(examination->truth());
    }
    const std::string residual = examination->residual_complaint();
    if (!residual.empty()) return residual;
  } catch (const InvalidInput&) {
    const std::string mismatch = operation.refusal_mismatch(question);
    if (!mismatch.empty()) return mismatch;
  }
  const std::size_t environment = environment_of(question);
  if (robust_bits(operation, question, environment) == robust_bits(operation, question, 0)) return "";
  return "robust answers differently in another environment (" + environment_name(environment) + ")";
}

}  // namespace

EACH_OPERATION("robust agrees with the oracle on every family, in every environment") {
  if (operation.card().is_method()) return;  // robust and oracle are those of the operation
  never(
      operation, "robust agrees with the oracle",
      [&](const Question& question) { return complaint(operation, question); }, 64);
}

}  // namespace touchstone::proptests
