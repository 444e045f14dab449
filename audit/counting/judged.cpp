// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/judged.h"

#include <algorithm>
#include <utility>

#include "audit/counting/generic.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {

Judgement judged(const Reply& reply, const Examination& examination, const Declaration& declaration) {
  Judgement judgement;
  judgement.degenerate = examination.degenerate();
  switch (reply.kind) {
    case Reply::Kind::unsupported: judgement.verdict = Verdict::unsupported; return judgement;
    case Reply::Kind::failed:
      judgement.verdict = Verdict::invalid;
      judgement.remark = reply.remark;
      return judgement;
    default: return examination.judge_engine(reply.answer, declaration);
  }
}

JudgedReply judged_and_kept(const Reply& reply, const Examination& examination, const Declaration& declaration) {
  Judgement judgement = judged(reply, examination, declaration);
  const bool shown = is_shown(judgement);
  return {std::move(judgement), shown ? kept(reply.answer) : Json(), reply.asked};
}

bool is_shown(const Judgement& judgement) {
  return judgement.verdict != Verdict::agree && judgement.verdict != Verdict::unsupported;
}

const Declaration& reference_declaration() {
  static const Declaration declaration{"reference", Declaration::Boundary::closed, false, 0};
  return declaration;
}

JudgedOutcome judged_outcome(const Judgement& judgement, const std::string& truth) {
  const Verdict verdict = judgement.verdict;
  return {verdict, truth,
          verdict == Verdict::invalid       ? no_valid_answer
          : verdict == Verdict::unsupported ? no_answer
                                            : judgement.said};
}

void count(Cell& cell, const Asked& asked, const Judgement& judgement, const Json& answer) {
  const Verdict verdict = judgement.verdict;
  const Range range = range_of(asked.question, asked.limits);
  const auto r = static_cast<std::size_t>(range);
  const JudgedOutcome outcome = judged_outcome(judgement, asked.truth);
  const std::string in_words =
      asked.operation.name() + "/" + name_of(verdict) + "/" + outcome.truth + "/" + outcome.answer;
  cell.hash += seed_of(asked.index, in_words.c_str(), 0);
  OutcomeCount& counted = cell.outcomes[outcome];
  ++counted.cases[r];
  if (verdict == Verdict::rounding && judgement.out_of_range) ++counted.out_of_range[r];
  // A decision that rounding may have made, or that is missing, reveals nothing about the convention.
  const bool meant =
      judgement.clear && (verdict != Verdict::rounding || judgement.number) && verdict != Verdict::invalid;
  if (meant && judgement.touch_reading > 0) ++cell.touches_closed;
  if (meant && judgement.touch_reading < 0) ++cell.touches_open;
  cell.surplus += judgement.surplus;
  cell.other_nearest += judgement.breaks_tie && verdict == Verdict::agree;
  cell.apart += judgement.apart;
  if (range == Range::ordinary && (is_finding(verdict) || verdict == Verdict::agree)) {
    const bool on_axis = has_direction_on_axis(asked.operation, asked.question);
    if (on_axis) cell.found_on_axis += is_finding(verdict) && verdict != Verdict::rounding;
    else cell.right_off_axis += verdict == Verdict::agree;
  }
  if (verdict == Verdict::agree || verdict == Verdict::inexact || judgement.number) {
    cell.worst_ulps = std::max(cell.worst_ulps, judgement.ulps);
  }
  if (!is_shown(judgement)) return;
  if (counted.example && counted.example->range < range) return;
  const std::size_t features = degenerate_features(asked.operation, asked.question, judgement.degenerate);
  Finding found{asked.question, judgement, nullptr, asked.index, range, features};
  if (counted.example && !shown_before(found, *counted.example)) return;
  found.answer = answer;
  found.vector = asked.vector;
  counted.example = std::move(found);
}

DrawStream case_draws(const Operation& operation, std::size_t family, std::uint64_t seed, std::uint64_t index,
                      bool record) {
  const std::string stream = operation.name() + "/" + operation.families()[family];
  return DrawStream::seeded(seed_of(seed, stream.c_str(), index), record);
}

}  // namespace touchstone::audit
