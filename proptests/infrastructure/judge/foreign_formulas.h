// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "audit/counting/judged.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/probes/fitted.h"
#include "catalogue/operation/row.h"
#include "proptests/uses.h"

/// Engines of one formula, asked in this process.
namespace touchstone::proptests {

struct Asking {
  std::uint64_t each = 60;  ///< questions of each family
  bool binary32 = false;    ///< the engine's number type; its formula takes doubles all the same
  bool ordinary_only = true;
  bool skew_boxes = false;
  std::string family{};  ///< that one alone; or all
  Declaration::Nearest nearest = Declaration::Nearest::any;
  const Operation* operation = nullptr;  ///< asked in the place of the row's
};

/// A plain yes or no, or a whole answer, as over a pipe.
inline Json plain_or_packed(const Operation&, bool answer) { return answer; }
template <class Answer>
Json plain_or_packed(const Operation& operation, const Answer& answer) {
  return parse_line(one_line(operation.answer_json(packed(answer))));
}

/// What an audit counts of a formula, which takes the arguments of the row's operation. `look` hears of every
/// judgement.
template <class Row, class Formula, class Look>
Tally audited(const Formula& formula, const Asking& asking, const Look& look) {
  const Operation& operation = asking.operation != nullptr ? *asking.operation : operation_of_row<Row>();
  Tally tally;
  tally.declaration = {"by formula", Declaration::Boundary::closed, asking.binary32, 0};
  tally.declaration.skew_boxes = asking.skew_boxes;
  tally.declaration.nearest = asking.nearest;
  tally.operations.push_back({operation.name(), {}});
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    if (!asking.family.empty() && asking.family != operation.families()[family]) continue;
    Cell cell;
    for (std::uint64_t i = 0; i < asking.each; ++i) {
      DrawStream draws = case_draws(operation, family, 1, i);
      Question question = operation.draw(draws, family);
      question = fitted(operation, question, tally.declaration);
      if (asking.ordinary_only && range_of(question) == Range::extreme) continue;
      try {
        const auto examination = operation.examine(question);
        const auto answer = applied(formula, unpacked<typename Row::Question>(question));
        const Json json = plain_or_packed(operation, answer);
        const Judgement judgement = examination->judge_engine(json, tally.declaration);
        count(cell, {operation, question, examination->outcome(), i}, judgement, json);
        look(*examination, judgement);
      } catch (const InvalidInput&) {
      }
    }
    tally.operations[0].families.emplace_back(operation.families()[family], std::move(cell));
  }
  return tally;
}
template <class Row, class Formula>
Tally audited(const Formula& formula, const Asking& asking = {}) {
  return audited<Row>(formula, asking, [](const Examination&, const Judgement&) {});
}

}  // namespace touchstone::proptests
