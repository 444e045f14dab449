// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/judgement.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <set>
#include <span>
#include <utility>

#include "catalogue/codec/expected.h"
#include "catalogue/judge/compare.h"
#include "catalogue/judge/tolerated.h"
#include "catalogue/operation/blame.h"
#include "catalogue/operation/judged_numbers.h"
#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {
namespace {

bool holds_numbers(const Shape& shape) {
  return shape.kind == Shape::Kind::number || std::any_of(shape.parts.begin(), shape.parts.end(),
                                                          [](const auto& part) { return holds_numbers(*part.shape); });
}

/// Adds to a judgement how `rounding` came about, and whether the question is degenerate.
Judgement with_particulars(Judgement judgement, const Examination& question, bool binary32) {
  if (judgement.verdict == Verdict::rounding)
    judgement.out_of_range = question.out_of_range(binary32) || products_underflow(question, binary32);
  judgement.degenerate = question.degenerate();
  return judgement;
}

int touch_reading(const Examination& question, const std::string& said) {
  if (!question.open()) return 0;
  return said == question.outcome() ? 1 : said == outcome_of(*question.row().answer, question.open()->words) ? -1 : 0;
}

/// The same for a list: all of it, all except the elements that only touch, or neither.
int covered_reading(const Examination& question, const EncodedValue<double>& answer) {
  if (!question.open()) return 0;
  const Shape& shape = *question.row().answer;
  if (covered(shape, question.solution().answer.words, answer.words).missing == 0) return 1;
  return covered(shape, question.open()->words, answer.words).missing == 0 ? -1 : 0;
}

/// answer: nullptr if it was a plain true or false.
Judgement wrong(const Examination& question, const EncodedValue<double>* answer, const Declaration& declaration,
                bool right_for_open_sets) {
  const auto& margin = question.margin();
  Judgement judgement;
  if (right_for_open_sets && declaration.boundary != Declaration::Boundary::closed) {
    judgement.verdict = Verdict::convention;
  } else if (margin &&
             tolerated(*margin, declaration.tolerance, question.row().metadata->margin_degree, question.question())) {
    judgement.verdict = Verdict::tolerance;
  } else {
    judgement.verdict = rounding_is_to_blame(question, answer, declaration) ? Verdict::rounding : Verdict::algorithm;
  }
  return judgement;
}

/// For an operation that has a plain reading.
Judgement judgement_of_yes_or_no(const Examination& question, bool answer, const Declaration& declaration) {
  const Shape& shape = *question.row().answer;
  const std::optional<EncodedTruth>& open = question.open();
  const std::optional<bool> right = yes_or_no(shape, question.solution().answer.words);
  const bool right_for_open = open && yes_or_no(shape, open->words) == answer;
  Judgement judgement = *right == answer ? Judgement{} : wrong(question, nullptr, declaration, right_for_open);
  if (open) judgement.touch_reading = *right == answer ? 1 : right_for_open ? -1 : 0;
  judgement.said = answer ? "true" : "false";
  return judgement;
}

/// Any number may be omitted, unless a checker needs all of them.
EncodedValue<double> read_answer(const Examination& question, const Json& json) {
  const RowFunctions& row = question.row();
  EncodedValue<double> answer;
  const bool partial = row.defect == nullptr;
  const char* const name = row.metadata->answer;
  if (!json.is_object()) {
    Json example = example_of(*row.answer);
    if (name[0] != 0) example = Json::object({{name, std::move(example)}});
    const bool plain = has_plain_reading(*row.answer);
    throw InvalidInput("answer",
                       expected("an object like " + one_line(example) + (plain ? ", or true or false" : ""), json));
  }
  if (name[0] == 0) {
    read_json(*row.answer, json, "answer", answer, read_answer_number, partial);
    return answer;
  }
  require_fields(json, "answer", {name});
  const std::string field = member_path("answer", name);
  if (!json.contains(name)) throw InvalidInput(field, "missing");
  read_json(*row.answer, json[name], field, answer, read_answer_number, partial);
  return answer;
}

/// The elements listed must be tuples of different indices in the question's lists, in as many lists as the truth has,
/// with the same names.
void require_places(const Examination& question, const EncodedValue<double>& answer) {
  const RowFunctions& row = question.row();
  const std::string field = "answer." + std::string(row.metadata->answer);
  const Word places = elements_of_lists(*row.question, question.question());
  const std::vector<Listed> lists = listed(*row.answer, answer.words),
                            truth = listed(*row.answer, question.solution().answer.words);
  if (lists.size() != truth.size())
    throw InvalidInput(field, "a reply to each of the " + std::to_string(truth.size()) + " queries");
  const bool replies = !row.answer->parts[0].shape->fixed;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const std::string reply = replies ? field + "[" + std::to_string(k) + "]" : field;
    if (std::strcmp(lists[k].name, truth[k].name) != 0)
      throw InvalidInput(reply, std::string("a reply of ") + truth[k].name);
    for (std::size_t i = 0; i < lists[k].elements.size(); ++i) {
      const auto& element = lists[k].elements[i];
      const std::set<Word> different(element.begin(), element.end());
      if (different.size() == element.size() && *different.rbegin() < places) continue;
      throw InvalidInput((replies ? reply + "." + lists[k].name : reply) + "[" + std::to_string(i) + "]",
                         element.size() == 1 ? "a place in the list" : "different places in the list");
    }
  }
}

/// The question with an answer for its truth that names the points nearest to the answer's and as near to each other as
/// those of the truth; nullptr if there is no other.
std::unique_ptr<const Examination> with_points_as_near(const Examination& question,
                                                       const EncodedValue<double>& partial_answer) {
  if (question.row().as_near == nullptr) return nullptr;
  const Shape& shape = *question.row().answer;
  const EncodedTruth& truth = question.solution().answer;
  EncodedValue<double> answer = question.nearest_truth();  // in place of omitted numbers
  for (const PairedNumber& pair : paired_numbers(shape, truth, partial_answer, Reading::partial))
    answer.numbers[pair.in_truth] = partial_answer.numbers[pair.in_answer];
  auto other = other_as_near(question, answer);
  return other ? std::make_unique<const Examination>(question, *std::move(other)) : nullptr;
}

/// For numbers that are too far from the truth's, or another decision, which may be that of a solution that is as near.
/// Returns false if it is not.
bool judge_numbers(Judgement& judgement, Comparison& found, const Examination& question,
                   const EncodedValue<double>& answer, const Declaration& declaration) {
  const double most_ulps = question.row().metadata->ulps;
  std::optional<JudgedNumber> worst;
  if (found.decision) worst = worst_number(question, answer, Reading::partial, declaration);
  if (const auto other = with_points_as_near(question, answer)) {
    Judgement ignored;
    const Comparison near = compared(*other, answer, Reading::partial, declaration.binary32, ignored);
    const bool within = near.finite && near.ulps <= most_ulps;
    const JudgedNumber as_near = !near.decision ? JudgedNumber{Verdict::algorithm, near.ulps, {}}
                                 : within       ? JudgedNumber{Verdict::agree, near.ulps, {}}
                                                : worst_number(*other, answer, Reading::partial, declaration);
    const bool tie = as_near.verdict == Verdict::agree || as_near.verdict == Verdict::inexact,
               any = declaration.nearest == Declaration::Nearest::any;
    if ((any && (tie || as_near.verdict == Verdict::rounding)) || (tie && !worst)) worst = as_near;
    if (tie) {
      judgement.breaks_tie = true;
      judgement.remark = "other points than the contract names, and as near";
      if (!any) worst->verdict = Verdict::algorithm;
    }
  }
  if (!worst) return false;
  judgement.verdict = worst->verdict;
  if (worst->verdict != Verdict::agree) judgement.number = worst->number;
  found.ulps = worst->ulps;
  return true;
}

Judgement judgement_of_answer(const Examination& question, const Json& json, const Declaration& declaration) {
  const RowFunctions& row = question.row();
  try {
    if (json.is_boolean() && has_plain_reading(*row.answer))
      return judgement_of_yes_or_no(question, json.get<bool>(), declaration);
    const EncodedValue<double> answer = read_answer(question, json);
    if (row.metadata->kind == Kind::covering) require_places(question, answer);
    Judgement judgement;
    Comparison found = compared(question, answer, Reading::partial, declaration.binary32, judgement);
    const std::string said = outcome_of(*row.answer, answer.words, row.defect == nullptr);
    const int reading =
        row.metadata->kind == Kind::covering ? covered_reading(question, answer) : touch_reading(question, said);
    const bool too_much = lists_too_much(judgement, declaration);
    if (too_much || (!found.decision && !judge_numbers(judgement, found, question, answer, declaration))) {
      const Judgement before = std::move(judgement);
      judgement = wrong(question, &answer, declaration, reading == -1 && !too_much);
      judgement.remark = found.decision ? "it lists what does not meet" : before.remark;
      judgement.surplus = before.surplus, judgement.apart = before.apart;
    } else if (found.decision && !found.finite) {
      judgement = {Verdict::invalid, found.ulps, "NaN or infinity where the truth is finite"};
    } else if (found.decision && found.ulps > row.metadata->ulps) {
      judge_numbers(judgement, found, question, answer, declaration);
    }
    judgement.ulps = found.ulps;
    judgement.touch_reading = reading;
    judgement.said = said;
    return judgement;
  } catch (const InvalidInput& refused) {
    return {Verdict::invalid, 0, refused.what()};
  }
}

}  // namespace

bool checks_numbers(const RowFunctions& row) { return row.defect != nullptr && holds_numbers(*row.answer); }

bool is_right_exactly(const Examination& question) {
  const RowFunctions& row = question.row();
  const EncodedTruth& truth = question.solution().answer;
  const EncodedValue<Exact>& answer = question.formula_exactly();
  const auto in_doubles = [&] {
    return encoded_with<double>(answer, [](const Exact& n) { return n.defined() ? nearest(n.value()) : std::nan(""); });
  };
  if (row.exact_defect != nullptr) {
    const auto defined = [](const Exact& number) { return number.defined(); };
    if (!std::all_of(answer.numbers.begin(), answer.numbers.end(), defined)) return false;
    const auto value = [](const Exact& number) { return number.value(); };
    return row.exact_defect(question.question(), encoded_with<mpq_class>(answer, value)).empty();
  }
  if (row.defect != nullptr) {
    // Numbers may be right exactly, and wrong once they are rounded.
    if (checks_numbers(row) && same_as_truth(*row.answer, truth, answer, Reading::complete)) return true;
    return row.defect(question.question(), in_doubles()).empty();
  }
  if (row.metadata->kind == Kind::covering) return covered(*row.answer, truth.words, in_doubles().words).missing == 0;
  return same_as_truth(*row.answer, truth, answer,
                       row.metadata->formula_answers_less ? Reading::less : Reading::complete);
}

bool formula_errs(const Examination& question) {
  Judgement ignored;
  const Comparison found = compared_formula(question, false, ignored);
  return !found.decision || (found.finite && found.ulps > question.row().metadata->ulps);
}

Judgement judgement_of_formula(const Examination& question, bool binary32) {
  const RowFunctions& row = question.row();
  Judgement judgement;
  const Comparison found = compared_formula(question, binary32, judgement);
  judgement.ulps = found.ulps;
  if (!found.decision) {
    // If running error analysis is certain of a decision, exact arithmetic decides alike, at a far higher price.
    // Numbers that a checker refuses may be off although no comparison was uncertain.
    const bool rounded = checks_numbers(row) || question.inconclusive(binary32);
    judgement.verdict = rounded && question.formula_right_exactly() ? Verdict::rounding : Verdict::algorithm;
  } else if (!found.finite) {
    judgement.verdict = Verdict::invalid;
    judgement.remark = "NaN or infinity where the truth is finite";
  } else if (found.ulps > row.metadata->ulps) {
    const Reading reading = row.metadata->formula_answers_less ? Reading::less : Reading::complete;
    const JudgedNumber worst = worst_number(question, question.formula(binary32), reading, {"", {}, binary32});
    judgement.verdict = question.formula_right_exactly() ? worst.verdict : Verdict::algorithm;
    judgement.number = worst.number;
    judgement.ulps = worst.ulps;
  }
  judgement.said = outcome_of(*row.answer, question.formula(binary32).words);
  judgement.touch_reading = touch_reading(question, judgement.said);
  return with_particulars(std::move(judgement), question, binary32);
}

Judgement judgement_of_robust(const Examination& question, std::size_t environment) {
  const RowFunctions& row = question.row();
  try {
    Judgement judgement;
    judgement.degenerate = question.degenerate();
    const EncodedValue<double>& answer = question.robust_answer(environment);
    const Comparison found = compared(question, answer, Reading::complete, false, judgement);
    judgement.ulps = found.ulps;
    judgement.said = outcome_of(*row.answer, answer.words);
    // For an implementation that promises to be right for all finite doubles only the algorithm can be to blame.
    if (!found.decision) judgement.verdict = Verdict::algorithm;
    else if (!found.finite) judgement.verdict = Verdict::invalid;
    else if (found.ulps > 0) judgement.verdict = Verdict::inexact;
    if (row.decision != nullptr) {
      const Word word = question.robust_decision(environment);
      if (word_in(*row.answer, question.solution().answer.words, *row.decision) != word) {
        judgement.verdict = Verdict::algorithm;
        judgement.remark = std::string("the decision alone is ") + row.decision->words[word];
      }
    }
    if (row.prepared != nullptr && row.prepared(question.question(), environment) != answer) {
      judgement.verdict = Verdict::algorithm;
      judgement.remark = "it answers otherwise of prepared shapes";
    }
    return judgement;
  } catch (const std::bad_alloc&) {
    throw;  // not an answer of robust
  } catch (const std::exception& thrown) {
    return {Verdict::invalid, 0, thrown.what()};
  }
}

Judgement judgement_of_engine(const Examination& question, const Json& answer, const Declaration& declaration) {
  Judgement judgement =
      with_particulars(judgement_of_answer(question, answer, declaration), question, declaration.binary32);
  if (judgement.touch_reading != 0) judgement.clear = is_clear(question, declaration.binary32);
  return judgement;
}

std::string residual_complaint(const Examination& question) {
  if (question.row().residuals == nullptr) return "";
  for (const mpq_class& residual : question.row().residuals(question.question(), question.robust_answer())) {
    if (sgn(residual) != 0) return "a residual that should be 0 is " + residual.get_str();
  }
  return "";
}

std::string broken_promise(const Examination& question) {
  const Examination::Tracking& tracking = question.tracking();
  if (tracking.compared_in_doubt) return "";
  return promise_holds(question.formula(), tracking.answer, question.formula_exactly())
             ? ""
             : "the reference in double is beyond its proved error bound";
}

}  // namespace touchstone::catalogue
