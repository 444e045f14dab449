// SPDX-License-Identifier: Apache-2.0
#include "catalogue/judge/examination.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "catalogue/codec/expected.h"
#include "catalogue/judge/tolerated.h"
#include "catalogue/judge/ulps.h"
#include "catalogue/operation.h"

namespace touchstone::audit {
namespace {

bool holds_numbers(const Shape& shape) {
  return shape.kind == Shape::Kind::number || std::any_of(shape.parts.begin(), shape.parts.end(),
                                                          [](const auto& part) { return holds_numbers(*part.shape); });
}

/// Where a checker sees numbers, what it says turns on every rounding.
bool checks_numbers(const RowFunctions& row) { return row.fault != nullptr && holds_numbers(*row.answer); }

}  // namespace

Examination::Examination(const Operation& operation, const Question& question)
    : operation_(operation),
      row_(operation.row()),
      question_(question),
      solution_(std::make_shared<Solution>(row_.solve(question))) {}

Examination::Examination(const Operation& method, const Examination& of_operation)
    : operation_(method), row_(method.row()), question_(of_operation.question_), solution_(of_operation.solution_) {}

Json Examination::truth() const { return operation_.answer_json(solution_->answer); }
Json Examination::rounded_truth() const {
  const auto rounded = tape_with<double>(solution_->answer, [](const TrueNumber& number) { return nearest(number); });
  // Where numbers are to be rounded otherwise, this is no right answer.
  if (row_.fault != nullptr && !row_.fault(question_, rounded).empty()) return robust();
  return operation_.answer_json(rounded);
}
std::string Examination::outcome() const { return outcome_of(*row_.answer, solution_->answer.words); }
bool Examination::touch() const { return open().has_value(); }
oracle::Certificate Examination::certificate() const { return solution_->certificate(); }

Tape<double> Examination::formula(bool binary32) const {
  return binary32 ? row_.reference_in_float(question_) : row_.reference(question_);
}

Json Examination::reference(bool binary32) const { return operation_.answer_json(formula(binary32)); }

Json Examination::robust() const {
  try {
    return operation_.answer_json(row_.robust(question_, 0));
  } catch (const InvalidInput& refused) {
    Json error = Json::object();
    error["error"]["field"] = refused.field();
    error["error"]["rule"] = refused.rule();
    return error;
  }
}

Comparison Examination::compared(const Tape<double>& answer, Reading reading, bool binary32,
                                 Judgement& judgement) const {
  Comparison found;
  if (row_.fault != nullptr) {
    judgement.remark = row_.fault(question_, answer);
    found.decision = judgement.remark.empty();
  } else if (row_.card->kind == Kind::covering && reading != Reading::complete) {
    const Covering covering = covered(solution_->answer, answer, row_.answer->parts[0].shape->word_count);
    found.decision = covering.missing == 0;
    judgement.surplus = covering.surplus;
  } else {
    found = audit::compared(*row_.answer, solution_->answer, answer, reading, binary32);
  }
  return found;
}

bool Examination::right_in_exact_arithmetic() const {
  const Tape<Exact> answer = row_.reference_exactly(question_);
  const auto in_doubles = [&] {
    return tape_with<double>(answer, [](const Exact& n) { return n.defined() ? nearest(n.value()) : std::nan(""); });
  };
  if (row_.exact_fault != nullptr) {
    const auto defined = [](const Exact& number) { return number.defined(); };
    if (!std::all_of(answer.numbers.begin(), answer.numbers.end(), defined)) return false;
    return row_.exact_fault(question_, tape_with<mpq_class>(answer, [](const Exact& n) { return n.value(); })).empty();
  }
  if (row_.fault != nullptr) {
    // Numbers may be right, and wrong as soon as they are rounded.
    if (checks_numbers(row_) && same_as_truth(*row_.answer, solution_->answer, answer, Reading::complete)) return true;
    return row_.fault(question_, in_doubles()).empty();
  }
  if (row_.card->kind == Kind::covering)
    return covered(solution_->answer, in_doubles(), row_.answer->parts[0].shape->word_count).missing == 0;
  return same_as_truth(*row_.answer, solution_->answer, answer,
                       row_.card->formula_answers_less ? Reading::less : Reading::complete);
}

/// What every judgement says beside its verdict: how `rounding` came about, and whether the question is degenerate.
Judgement Examination::with_particulars(Judgement judgement, bool binary32) const {
  if (judgement.verdict == Verdict::rounding)
    judgement.out_of_range = out_of_range(binary32) || products_underflow(binary32);
  judgement.degenerate = degenerate();
  return judgement;
}

Judgement Examination::judge_reference(bool binary32) const {
  return with_particulars(judge_formula(binary32), binary32);
}

Judgement Examination::judge_formula(bool binary32) const {
  const Tape<double> answer = formula(binary32);
  const bool less = row_.card->formula_answers_less || row_.card->kind == Kind::covering;
  Judgement judgement;
  const Comparison found = compared(answer, less ? Reading::less : Reading::complete, binary32, judgement);
  judgement.ulps = found.ulps;
  if (!found.decision) {
    // What running error analysis is sure of, exact arithmetic decides alike, at a far higher price.
    // Numbers that a checker refuses may be off although no comparison was in doubt.
    const bool rounded = checks_numbers(row_) || doubtful(binary32);
    judgement.verdict = rounded && right_in_exact_arithmetic() ? Verdict::rounding : Verdict::algorithm;
  } else if (!found.finite) {
    judgement.verdict = Verdict::invalid;
    judgement.remark = "NaN or infinity where the truth is finite";
  } else if (found.ulps > row_.card->ulps) {
    judgement.verdict = right_in_exact_arithmetic() ? Verdict::inexact : Verdict::algorithm;
  }
  judgement.said = outcome_of(*row_.answer, answer.words);
  judgement.touch_reading = touch_reading(judgement.said);
  return judgement;
}

Judgement Examination::judge_robust(std::size_t environment) const {
  try {
    Judgement judgement;
    judgement.degenerate = degenerate();
    const Tape<double> answer = row_.robust(question_, environment);
    const Comparison found = compared(answer, Reading::complete, false, judgement);
    judgement.ulps = found.ulps;
    judgement.said = outcome_of(*row_.answer, answer.words);
    // Whoever promises to be right for all finite doubles has only the algorithm to blame.
    if (!found.decision) judgement.verdict = Verdict::algorithm;
    else if (!found.finite) judgement.verdict = Verdict::invalid;
    else if (found.ulps > 0) judgement.verdict = Verdict::inexact;
    if (row_.decision != nullptr) {
      const Word word = row_.decide(question_, environment);
      if (word_in(*row_.answer, solution_->answer.words, *row_.decision) != word) {
        judgement.verdict = Verdict::algorithm;
        judgement.remark = std::string("the decision alone is ") + row_.decision->words[word];
      }
    }
    return judgement;
  } catch (const std::exception& thrown) {
    return {Verdict::invalid, 0, thrown.what()};
  }
}

std::string Examination::residual_complaint() const {
  if (row_.residuals == nullptr) return "";
  for (const mpq_class& residual : row_.residuals(question_, row_.robust(question_, 0))) {
    if (sgn(residual) != 0) return "a residual that should be 0 is " + residual.get_str();
  }
  return "";
}

std::string Examination::broken_promise() const {
  using Bounded = Tracked<double>;
  Bounded::doubtful() = false;
  const auto tracked = row_.reference_tracked(question_);
  if (Bounded::doubtful()) return "";
  return promise_holds(row_.reference(question_), tracked, row_.reference_exactly(question_))
             ? ""
             : "the reference in double is beyond its proved error bound";
}

const Examination::Tracking& Examination::tracked(bool binary32) const {
  std::optional<Tracking>& known = tracked_[binary32 ? 1 : 0];
  if (known) return *known;
  if (binary32) {
    Tracked<float>::doubtful() = Tracked<float>::out_of_range() = false;
    row_.track_in_float(question_);
    known = {Tracked<float>::doubtful() || checks_numbers(row_), Tracked<float>::out_of_range()};
  } else {
    Tracked<double>::doubtful() = Tracked<double>::out_of_range() = false;
    const auto numbers = row_.reference_tracked(question_).numbers;
    const auto rounded = [](const Tracked<double>& number) { return number.error() > 0; };
    const bool refusable = checks_numbers(row_) && std::any_of(numbers.begin(), numbers.end(), rounded);
    known = {Tracked<double>::doubtful() || refusable, Tracked<double>::out_of_range()};
  }
  return *known;
}

const std::optional<TrueTape>& Examination::open() const {
  if (!open_) {
    open_.emplace();
    if (row_.as_open_sets != nullptr) *open_ = row_.as_open_sets(solution_->answer, question_);
  }
  return *open_;
}

int Examination::touch_reading(const std::string& outcome) const {
  if (!open()) return 0;
  return outcome == this->outcome() ? 1 : outcome == outcome_of(*row_.answer, open()->words) ? -1 : 0;
}

/// The decision turns on products so small that formulas that compare products lose them.
bool Examination::products_underflow(bool binary32) const {
  return margin() && sgn(*margin()) != 0 && row_.card->margin_degree > 1 &&
         *margin() < exact_value(binary32 ? 0x1p-126 : 0x1p-1022);
}

/// The decision turns on less than a few units in the last place of the question's numbers: formulas that round at all
/// may take it for a touch.
bool Examination::beside_a_touch(bool binary32) const {
  if (!margin() || sgn(*margin()) == 0) return false;
  const int degree = row_.card->margin_degree;
  const mpq_class size = exact_value(greatest(question_)), few_units = 4 * exact_value(binary32 ? 0x1p-23 : 0x1p-52);
  return within(*margin(), few_units * size, size, degree);
}

/// The same of a list: all of it, all but what only touches, or neither.
int Examination::covered_reading(const Tape<double>& answer) const {
  if (!open()) return 0;
  const std::size_t each = row_.answer->parts[0].shape->word_count;
  if (covered(solution_->answer, answer, each).missing == 0) return 1;
  return covered(*open(), answer, each).missing == 0 ? -1 : 0;
}

bool Examination::formula_decides_rightly(bool binary32) const {
  const bool less = row_.card->formula_answers_less || row_.card->kind == Kind::covering;
  Judgement ignored;
  return compared(formula(binary32), less ? Reading::less : Reading::complete, binary32, ignored).decision;
}

/// For a foreign implementation rounding is to blame where the question is beside a touch, or where the slide's formula
/// in the engine's own number type is not sure of its decision (running error analysis) and decides wrongly too; of
/// numbers that a checker refuses, where the formula's are refused for rounding. Where the plainest formula comes out
/// right, the number type was good enough, and what is to blame is the choice of another.
bool Examination::rounding_is_to_blame(bool binary32) const {
  if (checks_numbers(row_)) return judge_formula(binary32).verdict == Verdict::rounding;
  return products_underflow(binary32) || beside_a_touch(binary32) ||
         (doubtful(binary32) && !formula_decides_rightly(binary32));
}

Judgement Examination::wrong(const Declaration& declaration, bool right_for_open_sets) const {
  Judgement judgement;
  if (right_for_open_sets && declaration.boundary != Declaration::Boundary::closed) {
    judgement.verdict = Verdict::convention;
  } else if (margin() && tolerated(*margin(), declaration.tolerance, row_.card->margin_degree, question_)) {
    judgement.verdict = Verdict::tolerance;
  } else {
    judgement.verdict = rounding_is_to_blame(declaration.binary32) ? Verdict::rounding : Verdict::algorithm;
  }
  return judgement;
}

Judgement Examination::judge_yes_or_no(bool answer, const Declaration& declaration) const {
  const std::optional<bool> right = yes_or_no(*row_.answer, solution_->answer.words);
  if (!right) return {Verdict::invalid, 0, "a plain true or false is no answer to this operation"};
  const bool right_for_open = open() && yes_or_no(*row_.answer, open()->words) == answer;
  Judgement judgement = *right == answer ? Judgement{} : wrong(declaration, right_for_open);
  if (open()) judgement.touch_reading = *right == answer ? 1 : right_for_open ? -1 : 0;
  judgement.said = answer ? "true" : "false";
  return judgement;
}

/// Any number may be left out, unless a checker must see them all.
Tape<double> Examination::read_answer(const Json& json) const {
  Tape<double> answer;
  const bool partial = row_.fault == nullptr;
  const char* const name = row_.card->answer;
  if (!json.is_object()) {
    Json example = example_of(*row_.answer);
    if (name[0] != 0) example = Json::object({{name, std::move(example)}});
    const bool plain = yes_or_no(*row_.answer, solution_->answer.words).has_value();
    throw InvalidInput("answer",
                       expected("an object like " + one_line(example) + (plain ? ", or true or false" : ""), json));
  }
  if (name[0] == 0) {
    read_json(*row_.answer, json, "answer", answer, read_answer_number, partial);
    return answer;
  }
  require_fields(json, "answer", {name});
  const std::string field = member_path("answer", name);
  if (!json.contains(name)) throw InvalidInput(field, "missing");
  read_json(*row_.answer, json[name], field, answer, read_answer_number, partial);
  return answer;
}

/// What is listed are tuples of different places in the question's list.
void Examination::require_places(const Tape<double>& answer) const {
  const std::size_t each = row_.answer->parts[0].shape->word_count;
  const Word places = longest_list(*row_.question, question_);
  for (std::size_t first = 1; first < answer.words.size(); first += each) {
    const auto element = std::span(answer.words).subspan(first, each);
    const std::set<Word> different(element.begin(), element.end());
    if (different.size() < each || *different.rbegin() >= places) {
      throw InvalidInput("answer." + std::string(row_.card->answer) + ("[" + std::to_string((first - 1) / each) + "]"),
                         "different places in the list");
    }
  }
}

Judgement Examination::judge_engine(const Json& json, const Declaration& declaration) const {
  return with_particulars(judge_answer(json, declaration), declaration.binary32);
}

Judgement Examination::judge_answer(const Json& json, const Declaration& declaration) const {
  try {
    if (json.is_boolean()) return judge_yes_or_no(json.get<bool>(), declaration);
    const Tape<double> answer = read_answer(json);
    if (row_.card->kind == Kind::covering) require_places(answer);
    Judgement judgement;
    const Comparison found = compared(answer, Reading::partial, declaration.binary32, judgement);
    const std::string said = outcome_of(*row_.answer, answer.words, row_.fault == nullptr);
    const int reading = row_.card->kind == Kind::covering ? covered_reading(answer) : touch_reading(said);
    if (!found.decision) {
      std::string remark = std::move(judgement.remark);
      judgement = wrong(declaration, reading == -1);
      judgement.remark = std::move(remark);
    } else if (!found.finite) {
      judgement = {Verdict::invalid, found.ulps, "NaN or infinity where the truth is finite"};
    } else if (found.ulps > row_.card->ulps) {
      judgement.verdict = Verdict::inexact;
    }
    judgement.ulps = found.ulps;
    judgement.touch_reading = reading;
    judgement.said = said;
    return judgement;
  } catch (const InvalidInput& refused) {
    return {Verdict::invalid, 0, refused.what()};
  }
}

}  // namespace touchstone::audit
