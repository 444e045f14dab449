// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/judged_numbers.h"

#include <algorithm>
#include <cmath>

#include "catalogue/judge/tolerated.h"
#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {
namespace {

/// A number of a formula, in the engine's number type.
struct FormulaNumber {
  double value, spread;
};
struct FormulaNumbers {
  /// By their indices in the truth; nullopt if the formula, which decides otherwise or omits it, has none.
  std::vector<std::optional<FormulaNumber>> at;
  /// The answer that the formula should have given: of several right answers the one nearest to its own.
  EncodedTruth truth;
  bool textbook = false;  ///< from the operation's own formula
};

FormulaNumbers numbers_of(const Examination& question, const EncodedValue<Tracked>& formula) {
  const EncodedTruth& truth = question.solution().answer;
  FormulaNumbers numbers{{}, other_as_near(question, in_doubles(formula)).value_or(truth)};
  numbers.at.resize(truth.numbers.size());
  for (const PairedNumber& pair : paired_numbers(*question.row().answer, truth, formula, Reading::less)) {
    const Tracked& number = formula.numbers[pair.in_answer];
    numbers.at[pair.in_truth] = {number.value(), number.spread()};
  }
  return numbers;
}

/// True if it divides by 0 in exact arithmetic, too: then nothing bounds its rounding.
bool formula_is_undefined(const Examination& question) {
  const std::vector<Exact>& numbers = question.formula_exactly().numbers;
  return !std::all_of(numbers.begin(), numbers.end(), [](const Exact& number) { return number.defined(); });
}

int gravity(Verdict verdict) {
  return verdict == Verdict::algorithm ? 3 : verdict == Verdict::rounding ? 2 : verdict == Verdict::inexact ? 1 : 0;
}

/// The greatest magnitude of a number of that meaning.
double greatest_of(Meaning meaning, const Shape& shape, const EncodedValue<double>& encoded) {
  struct Sizes {
    Meaning meaning;
    double greatest = 0;
    void number(const Shape& number, const Cursor<double>& at) {
      if (number.meaning == meaning) greatest = std::max(greatest, std::fabs(*at.number));
    }
    void word(const Shape&, const Cursor<double>&) {}
  } sizes{meaning};
  Cursor<double> at(encoded);
  walk_encoded(shape, at, sizes);
  return sizes.greatest;
}

/// The exact number; an irrational one to 60 digits below the least double.
mpq_class value_of(const TrueNumber& number) {
  return number.rational() ? number.rational_part() : number.enclosure(1074 + 200).low;
}

/// A limit that is not finite bounds nothing.
bool at_most(const mpq_class& size, double limit) { return !std::isfinite(limit) || size <= exact_value(limit); }

class NumberJudge {
 public:
  NumberJudge(const Examination& question, const Declaration& declaration)
      : question_(question), declaration_(declaration), unit_(declaration.binary32 ? 0x1p-24 : 0x1p-53) {
    const bool alone = question.row().standard.empty();
    if (alone || !formula_is_undefined(question)) {
      formulas_.push_back(numbers_of(question, question.tracking(declaration.binary32).answer));
      formulas_.back().textbook = true;
    }
    for (const Examination::Tracking& formula : question.standard(declaration.binary32))
      formulas_.push_back(numbers_of(question, formula.answer));
  }

  /// The verdict by the formula that excuses most.
  Verdict verdict_on(const PairedNumber& place, double answered) const {
    const mpq_class exact = value_of(question_.solution().answer.numbers[place.in_truth]),
                    gap = abs(exact_value(answered) - exact);
    if (place.meaning != Meaning::number && at_most(gap, declaration_.tolerance)) return Verdict::inexact;
    Verdict least = Verdict::algorithm;
    for (const FormulaNumbers& formula : formulas_) {
      const Verdict verdict = verdict_by(formula, place, exact, gap);
      if (gravity(verdict) < gravity(least)) least = verdict;
    }
    return least;
  }

 private:
  Verdict verdict_by(const FormulaNumbers& formula, const PairedNumber& place, const mpq_class& exact,
                     const mpq_class& gap) const {
    // Beyond the range the infinity is right, and if the formula returns it, nothing excuses a number.
    const double right = nearest(question_.solution().answer.numbers[place.in_truth], declaration_.binary32);
    const auto& number = formula.at[place.in_truth];
    if (std::isinf(right) && number && number->value == right) return Verdict::algorithm;
    const std::optional<double> spread = spread_at(formula, place);
    const bool has_a_digit = 2 * gap < abs(exact);
    const bool explained = spread ? at_most(gap, explained_spreads * *spread) : has_a_digit;
    if (explained && (has_a_digit || sgn(exact) == 0)) return Verdict::inexact;
    return explained || is_as_bad(formula, place, gap) || jumps() ? Verdict::rounding : Verdict::algorithm;
  }

  /// The possible rounding of a number of the truth, to first order; nullopt if the formula does not tell.
  std::optional<double> spread_at(const FormulaNumbers& formula, const PairedNumber& place) const {
    std::optional<double> spread;
    if (formula.at[place.in_truth]) spread = formula.at[place.in_truth]->spread;
    else if (question_.row().metadata->formula_answers_less) spread = spread_of_what_is_left_out(formula);
    // An engine that moves the origin rounds all coordinates; one that uses relative velocities rounds those.
    const RowFunctions& row = question_.row();
    double scale = 0;
    if (place.meaning == Meaning::place) scale = greatest_of(place.meaning, *row.question, question_.question());
    if (place.meaning == Meaning::direction) scale = greatest_of(place.meaning, *row.answer, question_.nearest_truth());
    return scale > 0 ? std::max(spread.value_or(0), unit_ * scale) : spread;
  }

  /// A number that the formula omits follows from those it has, and is equally far off relative to its greatest number.
  double spread_of_what_is_left_out(const FormulaNumbers& formula) const {
    double spread = 0, size = 0, greatest_left_out = 0;
    for (std::size_t i = 0; i < formula.at.size(); ++i) {
      if (formula.at[i])
        spread = std::max(spread, formula.at[i]->spread), size = std::max(size, std::fabs(formula.at[i]->value));
      else greatest_left_out = std::max(greatest_left_out, std::fabs(question_.nearest_truth().numbers[i]));
    }
    return spread / size * greatest_left_out;
  }

  bool is_as_bad(const FormulaNumbers& formula, const PairedNumber& place, const mpq_class& gap) const {
    const auto& number = formula.at[place.in_truth];
    if (!number)
      return formula.textbook && question_.judge_reference(declaration_.binary32).verdict == Verdict::rounding;
    if (!std::isfinite(number->value)) return true;
    const mpq_class own = abs(exact_value(number->value) - value_of(formula.truth.numbers[place.in_truth]));
    return explained_spreads * own >= gap;
  }

  /// True if a number jumps at a touch, and the question is near one.
  bool jumps() const {
    return question_.row().metadata->kind == Kind::measure && near_touch(question_, declaration_.binary32);
  }

  const Examination& question_;
  const Declaration& declaration_;
  double unit_;
  std::vector<FormulaNumbers> formulas_;
};

}  // namespace

std::optional<EncodedTruth> other_as_near(const Examination& question, const EncodedValue<double>& answer) {
  const RowFunctions& row = question.row();
  const auto finite = [](double number) { return std::isfinite(number); };
  if (row.as_near == nullptr || !std::all_of(answer.numbers.begin(), answer.numbers.end(), finite)) return std::nullopt;
  const EncodedTruth& truth = question.solution().answer;
  auto other = row.as_near(question.question(), truth, answer);
  if (other && other->numbers == truth.numbers) return std::nullopt;
  return other;
}

JudgedNumber worst_number(const Examination& question, const EncodedValue<double>& answer, Reading reading,
                          const Declaration& declaration) {
  const RowFunctions& row = question.row();
  const EncodedTruth& truth = question.solution().answer;
  const NumberJudge judge(question, declaration);
  JudgedNumber worst;
  for (const PairedNumber& pair : paired_numbers(*row.answer, truth, answer, reading)) {
    const double answered = answer.numbers[pair.in_answer];
    const TrueNumber& exact = truth.numbers[pair.in_truth];
    const double ulps = distance_in_ulps(answered, exact, declaration.binary32);
    if (!(ulps > row.metadata->ulps)) continue;
    const Verdict verdict = judge.verdict_on(pair, answered);
    if (gravity(verdict) < gravity(worst.verdict)) continue;
    if (gravity(verdict) > gravity(worst.verdict) || ulps > worst.ulps)
      worst = {verdict, ulps, {nearest(exact, declaration.binary32), answered}};
  }
  return worst;
}

bool near_touch(const Examination& question, bool binary32) {
  const auto& margin = question.margin();
  if (!margin || sgn(*margin) == 0) return false;
  const mpq_class size = exact_value(greatest(question.question())),
                  few_units = 4 * exact_value(binary32 ? 0x1p-23 : 0x1p-52);
  return within(*margin, few_units * size, size, question.row().metadata->margin_degree);
}

}  // namespace touchstone::catalogue
