// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "catalogue/codec/json.h"
#include "catalogue/judge/compare.h"
#include "catalogue/judge/verdict.h"
#include "catalogue/row_functions.h"

namespace touchstone::audit {

class Operation;

/// One question with everything that can be said about it. The oracle is asked once, when it is made; all else is
/// computed when asked for.
class Examination {
 public:
  /// Throws InvalidInput where the oracle refuses.
  Examination(const Operation& operation, const Question& question);
  /// The same question of a method of the operation: the truth is the same.
  Examination(const Operation& method, const Examination& of_operation);

  Json truth() const;           ///< exact, "p/q"
  Json rounded_truth() const;   ///< every number the nearest double
  std::string outcome() const;  ///< the truth's enumerator ("overlap"), or "value"
  bool touch() const;           ///< the truth is a touch: open and closed sets answer differently
  const Solution& solution() const { return *solution_; }
  /// Empty where the operation decides nothing.
  const std::optional<mpq_class>& margin() const { return solution_->margin; }
  oracle::Certificate certificate() const;

  Json reference(bool binary32 = false) const;  ///< the slide's formula in double or float
  Json robust() const;

  Judgement judge_reference(bool binary32 = false) const;
  /// In that floating-point environment (see catalogue/judge/environment.h).
  Judgement judge_robust(std::size_t environment = 0) const;
  /// `answer`: the engine's "answer" value: an object with the operation's fields, or true / false.
  Judgement judge_engine(const Json& answer, const Declaration& declaration) const;

  /// The contract's promise for the double version, tested: empty if it holds here. Where running error analysis proves
  /// that rounding cannot have changed a decision, reference in double must decide as in exact arithmetic, and its
  /// numbers must lie within the proved bound.
  std::string broken_promise() const;
  /// Whether rounding may have changed the course of the formula, by running error analysis.
  bool doubtful(bool binary32 = false) const { return tracked(binary32).doubtful; }
  /// Whether a number left the range of double or float in the formula (catalogue/judge/tracked.h).
  bool out_of_range(bool binary32 = false) const { return tracked(binary32).out_of_range; }
  bool degenerate() const { return margin() && sgn(*margin()) == 0; }
  /// What is wrong with robust's answer where a residual should be exactly zero; empty where none is.
  std::string residual_complaint() const;

 private:
  Comparison compared(const Tape<double>& answer, Reading reading, bool binary32, Judgement& judgement) const;
  bool right_in_exact_arithmetic() const;
  Tape<double> formula(bool binary32) const;
  Tape<double> read_answer(const Json& json) const;
  void require_places(const Tape<double>& answer) const;
  Judgement wrong(const Declaration& declaration, bool right_for_open_sets) const;
  Judgement judge_yes_or_no(bool answer, const Declaration& declaration) const;
  const std::optional<TrueTape>& open() const;
  struct Tracking {
    bool doubtful, out_of_range;
  };
  const Tracking& tracked(bool binary32) const;
  Judgement judge_formula(bool binary32) const;
  Judgement judge_answer(const Json& answer, const Declaration& declaration) const;
  bool formula_decides_rightly(bool binary32) const;
  bool products_underflow(bool binary32) const;
  bool beside_a_touch(bool binary32) const;
  bool rounding_is_to_blame(bool binary32) const;
  Judgement with_particulars(Judgement judgement, bool binary32) const;
  int touch_reading(const std::string& outcome) const;
  int covered_reading(const Tape<double>& answer) const;

  const Operation& operation_;
  const RowFunctions& row_;
  Question question_;
  std::shared_ptr<const Solution> solution_;
  mutable std::optional<std::optional<TrueTape>> open_;
  mutable std::array<std::optional<Tracking>, 2> tracked_;
};

}  // namespace touchstone::audit
