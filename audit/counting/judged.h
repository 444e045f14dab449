// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"

/// One case of an audit: drawn, judged and counted.
namespace touchstone::audit {

/// The verdict on an engine's reply to a question.
Judgement judged(const Reply& reply, const Examination& examination, const Declaration& declaration);

/// The part of a reply that is kept.
struct JudgedReply {
  Judgement judgement;  ///< if the engine was not asked, its remark says why
  Json answer;          ///< as kept; null if the verdict is not a finding
  bool asked = true;
};
JudgedReply judged_and_kept(const Reply& reply, const Examination& examination, const Declaration& declaration);

/// True if a case with this judgement may be an example of its outcome.
bool is_shown(const Judgement& judgement);

/// A case in the form in which it is counted.
struct Asked {
  const Operation& operation;
  const Question& question;
  std::string truth;        ///< Examination::outcome(), or "refused"
  std::uint64_t index = 0;  ///< its number within its operation and family
  Limits limits = {};
  std::string vector{};  ///< as in Finding
};

/// Counts a judged case into a cell, and keeps it, with its answer as kept, if it is the best example of its outcome.
void count(Cell& cell, const Asked& asked, const Judgement& judgement, const Json& answer = nullptr);

/// The outcome of a judged case.
JudgedOutcome judged_outcome(const Judgement& judgement, const std::string& truth);

/// The declaration of our reference in double, as if it were a foreign engine.
const Declaration& reference_declaration();

/// The draws of case `index` of a family.
DrawStream case_draws(const Operation& operation, std::size_t family, std::uint64_t seed, std::uint64_t index,
                      bool record = false);

}  // namespace touchstone::audit
