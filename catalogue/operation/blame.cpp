// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/blame.h"

#include <algorithm>

#include "catalogue/numbers/ulps.h"
#include "catalogue/operation/judged_numbers.h"
#include "catalogue/operation/judgement.h"

namespace touchstone::catalogue {
namespace {

/// The number of elements that the lists of an answer could hold beyond the truth.
std::uint64_t most_surplus(const Examination& question) {
  const RowFunctions& row = question.row();
  const std::vector<Listed> truth = listed(*row.answer, question.solution().answer.words);
  const std::vector<std::uint64_t> places =
      row.places != nullptr
          ? row.places(question.question())
          : std::vector<std::uint64_t>(truth.size(), elements_of_lists(*row.question, question.question()));
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint64_t n = places[i], all = truth[i].width == 1 ? n : n < 2 ? 0 : n * (n - 1) / 2;  // or pairs
    most += all - truth[i].elements.size();
  }
  return most;
}

/// For an answer that a checker refuses: true if it is well formed, and on the wrong side by no more than the rounding
/// of sums of products of the question's greatest numbers, or by about as much as the textbook formula's answer in that
/// number type. NaN and infinities may have left the range.
bool may_be_rounding(const Examination& question, const EncodedValue<double>& answer, bool binary32) {
  constexpr double most_units = 256;
  const auto excess_of = [&](const EncodedValue<double>& encoded) {
    return question.row().excess(question.question(), encoded, question.nearest_truth());
  };
  const Excess excess = excess_of(answer);
  if (!excess) return checks_numbers(question.row()) && question.out_of_range(binary32);
  if (*excess <= most_units * (binary32 ? 0x1p-23 : 0x1p-52)) return true;
  const Excess of_formula = excess_of(question.formula(binary32));
  return of_formula && *excess <= explained_spreads * *of_formula;
}

}  // namespace

Comparison compared(const Examination& question, const EncodedValue<double>& answer, Reading reading, bool binary32,
                    Judgement& judgement) {
  const RowFunctions& row = question.row();
  const EncodedTruth& truth = question.solution().answer;
  Comparison found;
  if (row.defect != nullptr) {
    judgement.remark = row.defect(question.question(), answer);
    found.decision = judgement.remark.empty();
  } else if (row.metadata->kind == Kind::covering && reading != Reading::complete) {
    const Covering covering = covered(*row.answer, truth.words, answer.words);
    found.decision = covering.missing == 0;
    judgement.surplus = covering.surplus;
    judgement.apart = most_surplus(question);
  } else {
    found = compared(*row.answer, truth, answer, reading, binary32);
  }
  return found;
}

Comparison compared_formula(const Examination& question, bool binary32, Judgement& judgement) {
  const Metadata& metadata = *question.row().metadata;
  const bool less = metadata.formula_answers_less || metadata.kind == Kind::covering;
  return compared(question, question.formula(binary32), less ? Reading::less : Reading::complete, binary32, judgement);
}

bool products_underflow(const Examination& question, bool binary32) {
  const auto& margin = question.margin();
  return margin && sgn(*margin) != 0 && question.row().metadata->margin_degree > 1 &&
         *margin < exact_value(binary32 ? 0x1p-126 : 0x1p-1022);
}

bool lists_too_much(const Judgement& judgement, const Declaration& declaration) {
  return declaration.pairs == Declaration::Pairs::exact && judgement.surplus > 0;
}

const char* standard_formula_that_rounds(const Examination& question, bool binary32) {
  const std::vector<Examination::Tracking>& formulas = question.standard(binary32);
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    const Examination::Tracking& formula = formulas[i];
    if (!formula.inconclusive) continue;
    const char* const name = question.row().standard[i].name;
    if (question.degenerate()) return name;
    const EncodedValue<double> answer = in_doubles(formula.answer);
    Judgement ignored;
    if (!compared(question, answer, Reading::less, binary32, ignored).decision) return name;
  }
  return nullptr;
}

bool is_clear(const Examination& question, bool binary32) {
  constexpr std::uint64_t most_steps = std::uint64_t{1} << 16;
  const std::uint64_t n = elements_of_lists(*question.row().question, question.question());
  if (steps_of(question.row().metadata->time.reference, n) > most_steps || question.inconclusive(binary32))
    return false;
  const std::vector<Examination::Tracking>& others = question.standard(binary32);
  return std::none_of(others.begin(), others.end(), [](const auto& formula) { return formula.inconclusive; });
}

bool rounding_is_to_blame(const Examination& question, const EncodedValue<double>* answer,
                          const Declaration& declaration) {
  const bool binary32 = declaration.binary32;
  if (question.row().excess != nullptr && answer != nullptr && !may_be_rounding(question, *answer, binary32))
    return false;
  if (checks_numbers(question.row())) return question.judge_reference(binary32).verdict == Verdict::rounding;
  if (products_underflow(question, binary32) || near_touch(question, binary32)) return true;
  Judgement formula;
  const bool textbook_rounds =
      question.inconclusive(binary32) &&
      (!compared_formula(question, binary32, formula).decision || lists_too_much(formula, declaration));
  return textbook_rounds || standard_formula_that_rounds(question, binary32) != nullptr;
}

}  // namespace touchstone::catalogue
