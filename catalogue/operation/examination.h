// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/operation/once.h"
#include "catalogue/operation/row_functions.h"

namespace touchstone::catalogue {

class Operation;

/// One question with everything that is known about it. The constructor asks the oracle; everything else is computed on
/// first use, and kept. Not thread-safe.
class Examination {
 public:
  /// Throws InvalidInput if the oracle refuses.
  Examination(const Operation& operation, const Question& question);
  /// The same question of another implementation of the operation: the truth is the same.
  Examination(const Operation& implementation, const Examination& of_operation);
  /// The same question with another right answer in place of the truth.
  Examination(const Examination& question, EncodedTruth other);

  const Operation& operation() const { return operation_; }
  const RowFunctions& row() const { return row_; }
  const Question& question() const { return question_; }

  const Solution& solution() const { return *solution_; }
  /// nullopt if the operation decides nothing.
  const std::optional<mpq_class>& margin() const { return solution_->margin; }
  bool degenerate() const { return margin() && sgn(*margin()) == 0; }
  const oracle::Certificate& certificate() const;
  /// The answer for open sets; nullopt unless the truth is a touch.
  const std::optional<EncodedTruth>& open() const;
  bool touch() const { return open().has_value(); }
  /// Every number of the truth as the nearest double.
  const EncodedValue<double>& nearest_truth() const;
  std::string outcome() const;  ///< the truth's enumerator ("overlap"), or "value"
  Json truth() const;           ///< exact, "p/q"
  Json rounded_truth() const;   ///< a right answer in doubles
  /// The question and the truth as figures.
  const Drawing& drawing() const;

  /// The textbook formula's answer in double or float.
  const EncodedValue<double>& formula(bool binary32 = false) const;
  const EncodedValue<Exact>& formula_exactly() const;
  /// True if that is right.
  bool formula_right_exactly() const;
  /// The formula under running error analysis (catalogue/numbers/tracked.h).
  struct Tracking {
    bool compared_in_doubt = false;  ///< rounding may have changed a comparison
    bool inconclusive = false;       ///< or a number that the checker reads
    bool out_of_range = false;       ///< a number left the range of double or float
    EncodedValue<Tracked> answer;
  };
  const Tracking& tracking(bool binary32 = false) const;
  /// The same of the other formulas of textbooks.
  const std::vector<Tracking>& standard(bool binary32 = false) const;
  /// True if rounding may have changed the course of the formula.
  bool inconclusive(bool binary32 = false) const { return tracking(binary32).inconclusive; }
  bool out_of_range(bool binary32 = false) const { return tracking(binary32).out_of_range; }
  Json reference(bool binary32 = false) const;

  /// The answer of robust in that floating-point environment (catalogue/judge/environment.h). Throws what robust
  /// throws.
  const EncodedValue<double>& robust_answer(std::size_t environment = 0) const;
  /// Its decision alone, if it has one.
  Word robust_decision(std::size_t environment = 0) const;
  Json robust() const;

  const Judgement& judge_reference(bool binary32 = false) const;
  const Judgement& judge_robust(std::size_t environment = 0) const;
  /// `answer`: the engine's "answer" value: an object with the operation's fields, or true / false.
  Judgement judge_engine(const Json& answer, const Declaration& declaration) const;

 private:
  struct InEnvironment {
    Once<EncodedValue<double>> answer;
    Once<Word> decision;
    Once<Judgement> judgement;
  };
  struct InNumbers {
    Once<EncodedValue<double>> answer;
    Once<Tracking> tracking;
    Once<std::vector<Tracking>> standard;
    Once<Judgement> judgement;
  };
  Tracking tracked(const TrackedFormula& formula, bool binary32) const;

  const Operation& operation_;
  const RowFunctions& row_;
  Question question_;
  std::shared_ptr<const Solution> solution_;
  Once<oracle::Certificate> certificate_;
  Once<std::optional<EncodedTruth>> open_;
  Once<EncodedValue<double>> nearest_;
  Once<Drawing> drawing_;
  std::array<InNumbers, 2> formula_;  ///< in double, in float
  Once<EncodedValue<Exact>> exactly_;
  Once<bool> right_exactly_;
  mutable std::map<std::size_t, InEnvironment> robust_;
};

}  // namespace touchstone::catalogue
