// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/examination.h"

#include <algorithm>

#include "catalogue/operation/judgement.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/truth_drawing.h"

namespace touchstone::catalogue {

Examination::Examination(const Operation& operation, const Question& question)
    : operation_(operation),
      row_(operation.row()),
      question_(question),
      solution_(std::make_shared<Solution>(row_.solve(question))) {}

Examination::Examination(const Operation& implementation, const Examination& of_operation)
    : operation_(implementation),
      row_(implementation.row()),
      question_(of_operation.question_),
      solution_(of_operation.solution_) {}

Examination::Examination(const Examination& question, EncodedTruth other)
    : operation_(question.operation_),
      row_(question.row_),
      question_(question.question_),
      solution_(std::make_shared<Solution>(
          Solution{std::move(other), question.solution_->margin, question.solution_->certificate})) {}

const oracle::Certificate& Examination::certificate() const {
  return certificate_.value([&] { return solution_->certificate(); });
}

const std::optional<EncodedTruth>& Examination::open() const {
  return open_.value([&]() -> std::optional<EncodedTruth> {
    if (row_.as_open_sets == nullptr) return std::nullopt;
    return row_.as_open_sets(solution_->answer, question_);
  });
}

const EncodedValue<double>& Examination::nearest_truth() const {
  const auto rounded = [](const TrueNumber& number) { return nearest(number); };
  return nearest_.value([&] { return encoded_with<double>(solution_->answer, rounded); });
}

std::string Examination::outcome() const { return outcome_of(*row_.answer, solution_->answer.words); }
Json Examination::truth() const { return operation_.answer_json(solution_->answer); }

Json Examination::rounded_truth() const {
  // If numbers are to be rounded differently, the nearest ones are not a right answer.
  if (row_.defect != nullptr && !row_.defect(question_, nearest_truth()).empty()) return robust();
  return operation_.answer_json(nearest_truth());
}

const Drawing& Examination::drawing() const {
  return drawing_.value([&] { return drawing_of(*this); });
}

const EncodedValue<double>& Examination::formula(bool binary32) const {
  return formula_[binary32].answer.value(
      [&] { return binary32 ? in_doubles(tracking(true).answer) : row_.reference(question_); });
}

const EncodedValue<Exact>& Examination::formula_exactly() const {
  return exactly_.value([&] { return row_.reference_exactly(question_); });
}

bool Examination::formula_right_exactly() const {
  return right_exactly_.value([&] { return is_right_exactly(*this); });
}

Examination::Tracking Examination::tracked(const TrackedFormula& formula, bool binary32) const {
  Tracked::inconclusive() = Tracked::out_of_range() = false;
  Tracking known;
  known.answer = formula.ask(question_, binary32);
  known.compared_in_doubt = Tracked::inconclusive();
  known.out_of_range = Tracked::out_of_range();
  const auto rounded = [&](const Tracked& number) { return binary32 || number.error() > 0; };
  const auto& numbers = known.answer.numbers;
  known.inconclusive =
      known.compared_in_doubt || (checks_numbers(row_) && std::any_of(numbers.begin(), numbers.end(), rounded));
  return known;
}

const Examination::Tracking& Examination::tracking(bool binary32) const {
  return formula_[binary32].tracking.value([&] { return tracked(row_.reference_tracked, binary32); });
}

const std::vector<Examination::Tracking>& Examination::standard(bool binary32) const {
  return formula_[binary32].standard.value([&] {
    std::vector<Tracking> all;
    for (const TrackedFormula& formula : row_.standard) all.push_back(tracked(formula, binary32));
    return all;
  });
}

Json Examination::reference(bool binary32) const { return operation_.answer_json(formula(binary32)); }

const EncodedValue<double>& Examination::robust_answer(std::size_t environment) const {
  return robust_[environment].answer.value([&] { return row_.robust(question_, environment); });
}

Word Examination::robust_decision(std::size_t environment) const {
  return robust_[environment].decision.value([&] { return row_.decide(question_, environment); });
}

Json Examination::robust() const {
  try {
    return operation_.answer_json(robust_answer());
  } catch (const InvalidInput& refused) {
    Json error = Json::object();
    error["error"]["field"] = refused.field();
    error["error"]["rule"] = refused.rule();
    return error;
  }
}

const Judgement& Examination::judge_reference(bool binary32) const {
  return formula_[binary32].judgement.value([&] { return judgement_of_formula(*this, binary32); });
}

const Judgement& Examination::judge_robust(std::size_t environment) const {
  return robust_[environment].judgement.value([&] { return judgement_of_robust(*this, environment); });
}

Judgement Examination::judge_engine(const Json& answer, const Declaration& declaration) const {
  return judgement_of_engine(*this, answer, declaration);
}

}  // namespace touchstone::catalogue
