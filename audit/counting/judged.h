// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"

/// One case of an audit: drawn, judged and counted.
namespace touchstone::audit {

/// The verdict on what an engine replied to a question.
Judgement judged(const Reply& reply, const Examination& examination, const Declaration& declaration);

/// What is kept of a reply.
struct JudgedReply {
  Judgement judgement;  ///< where the engine was not asked, its remark says why
  Json answer;          ///< as kept; null where the judgement is no finding's
  bool asked = true;
};
JudgedReply judged_and_kept(const Reply& reply, const Examination& examination, const Declaration& declaration);

/// Whether a case with this judgement may be an example of its way of answering.
bool is_shown(const Judgement& judgement);

/// A case as it is counted.
struct Asked {
  const Operation& operation;
  const Question& question;
  std::string truth;        ///< Examination::outcome(), or "refused"
  std::uint64_t index = 0;  ///< within its operation and family
  Limits limits = {};
  std::string vector{};  ///< as in Finding
};

/// Counts a judged case into a cell, and keeps it, with its answer as kept, if it is the best example of its way of
/// answering.
void count(Cell& cell, const Asked& asked, const Judgement& judgement, const Json& answer = nullptr);

/// How a judged case was answered.
Way way_of(const Judgement& judgement, const std::string& truth);

/// Our reference in double, as if it were somebody's engine.
const Declaration& reference_declaration();

/// The draws that give case `index` of a family.
DrawStream case_draws(const Operation& operation, std::size_t family, std::uint64_t seed, std::uint64_t index,
                      bool record = false);

}  // namespace touchstone::audit
