// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>

#include "catalogue/row.h"
#include "catalogue/judge/compare.h"
#include "catalogue/judge/environment.h"
#include "catalogue/judge/tolerated.h"
#include "oracle/truth.h"

namespace touchstone::audit {

/// The typed examination of one question of a row.
template <class Row>
class ExaminationOf final : public Examination {
 public:
  using Asked = typename Row::Question;
  using Answer = answer_t<Row>;
  using Exactly = rebound_t<Answer, mpq_class>;
  /// What an engine says: any number may be left out, unless a checker must see them all.
  static constexpr bool is_checked = requires(const Asked& asked, const Answer& answer) { Row::fault(asked, answer); };
  using Said = std::conditional_t<is_checked, Answer, rebound_t<Answer, std::optional<double>>>;

  /// Throws InvalidInput where the oracle refuses.
  explicit ExaminationOf(const Asked& question) : question_(question), truth_(ask_oracle<Row>(question)) {}

  Json truth() const override { return answer_json(truth_.answer); }
  Json rounded_truth() const override {
    return answer_json(converted<double>(truth_.answer, [](const mpq_class& number) { return nearest(number); }));
  }
  std::string outcome() const override { return word_of(truth_.answer); }
  bool touch() const override { return open_reading().has_value(); }
  mpq_class margin() const override { return truth_.margin; }
  oracle::Certificate certificate() const override { return ask_certificate<Row>(question_); }

  Json reference(bool binary32) const override {
    return binary32 ? answer_json(run<float>()) : answer_json(run<double>());
  }
  Json robust() const override {
    try {
      return answer_json(ask_robust<Row>(question_));
    } catch (const InvalidInput& refused) {
      Json error = Json::object();
      error["error"]["field"] = refused.field();
      error["error"]["rule"] = refused.rule();
      return error;
    }
  }

  Judgement judge_reference(bool binary32) const override {
    return binary32 ? judge_formula<float>() : judge_formula<double>();
  }

  using Examination::judge_robust;
  Judgement judge_robust(std::size_t environment) const override {
    try {
      const auto answer = in_environment(environment, question_, [](const Asked& q) { return ask_robust<Row>(q); });
      const Comparison found = compared(answer, true, false);
      Judgement judgement{Verdict::agree, found.ulps, ""};
      // Whoever promises to be right for all finite doubles has only the algorithm to blame.
      if (!found.decision) judgement.verdict = Verdict::algorithm;
      else if (!found.finite) judgement.verdict = Verdict::invalid;
      else if (found.ulps > 0) judgement.verdict = Verdict::inexact;
      if constexpr (decides_alone<Row>) {
        const auto word = in_environment(environment, question_, [](const Asked& q) { return decision_alone<Row>(q); });
        if (word_in<std::remove_const_t<decltype(word)>>(truth_.answer) != word)
          return {Verdict::algorithm, 0, "the decision alone is " + word_of(word)};
      }
      return judgement;
    } catch (const std::exception& thrown) {
      return {Verdict::invalid, 0, thrown.what()};
    }
  }

  Judgement judge_engine(const Json& answer, const Declaration& declaration) const override {
    try {
      if (answer.is_boolean()) return judge_yes_or_no(answer.get<bool>(), declaration);
      return judge_answer(read_answer(answer), declaration);
    } catch (const InvalidInput& refused) {
      return {Verdict::invalid, 0, "answer." + std::string(refused.what())};
    }
  }

  std::string broken_promise() const override {
    using Bounded = Tracked<double>;
    Bounded::doubtful() = false;
    const auto tracked = run<Bounded>();
    if (Bounded::doubtful()) return "";
    const auto exact = run<Exact>();
    return promise_holds(run<double>(), tracked, exact) ? ""
                                                        : "the reference in double is beyond its proved error bound";
  }

  template <class A>
  static Json answer_json(const A& answer) {
    Json bare = to_json(answer);
    if (Row::card().answer[0] == 0) return bare;
    Json named = Json::object();
    named[Row::card().answer] = std::move(bare);
    return named;
  }

 private:
  template <class Real>
  rebound_t<Answer, Real> run() const {
    const auto asked = converted<Real>(question_, [](double number) {
      if constexpr (std::is_same_v<Real, Exact>) return Exact(exact_value(number));
      else if constexpr (std::is_same_v<Real, float>) return static_cast<float>(number);
      else if constexpr (std::is_same_v<Real, Tracked<float>>) return Tracked<float>(static_cast<float>(number));
      else return Real(number);
    });
    return ask_reference<Row>(asked);
  }

  template <class A>
  Comparison compared(const A& answer, bool complete, bool binary32) const {
    Comparison found;
    if constexpr (requires { Row::fault(question_, answer); }) {
      found.decision = Row::fault(question_, answer).empty();
    } else {
      compare(truth_.answer, answer, complete, binary32, found);
    }
    return found;
  }

  template <class A>
  bool right_in_exact_arithmetic(const A& answer) const {
    if constexpr (requires { Row::fault(question_, answer); }) {
      return Row::fault(question_, answer).empty();
    } else {
      return same_as_truth(truth_.answer, answer, !Row::card().formula_answers_less);
    }
  }

  std::optional<Exactly> open_reading() const {
    if constexpr (requires { Row::as_open_sets(truth_.answer, question_); }) {
      return Row::as_open_sets(truth_.answer, question_);
    }
    return std::nullopt;
  }

  template <class Real>
  Judgement judge_formula() const {
    const auto answer = run<Real>();
    const Comparison found = compared(answer, !Row::card().formula_answers_less, std::is_same_v<Real, float>);
    Judgement judgement{Verdict::agree, found.ulps, ""};
    if (!found.decision) {
      judgement.verdict = right_in_exact_arithmetic(run<Exact>()) ? Verdict::rounding : Verdict::algorithm;
    } else if (!found.finite) {
      judgement.verdict = Verdict::invalid;
      judgement.remark = "NaN or infinity where the truth is finite";
    } else if (found.ulps > Row::card().ulps) {
      judgement.verdict = right_in_exact_arithmetic(run<Exact>()) ? Verdict::inexact : Verdict::algorithm;
    }
    judgement.touch_reading = touch_reading(word_of(answer));
    return judgement;
  }

  /// For a foreign implementation: rounding is to blame if the slide's formula, in the engine's own number type, cannot be
  /// sure of its decision here either (running error analysis); else nothing but the algorithm can be.
  Verdict blame(const Declaration& declaration) const {
    const bool doubt = declaration.binary32 ? doubtful<float>() : doubtful<double>();
    return doubt ? Verdict::rounding : Verdict::algorithm;
  }

  template <class Float>
  bool doubtful() const {
    Tracked<Float>::doubtful() = false;
    run<Tracked<Float>>();
    return Tracked<Float>::doubtful();
  }

  int touch_reading(const std::string& word) const {
    const std::optional<Exactly> open = open_reading();
    if (!open) return 0;
    return word == word_of(truth_.answer) ? 1 : word == word_of(*open) ? -1 : 0;
  }

  Judgement wrong(const Declaration& declaration, bool right_for_open_sets) const {
    Judgement judgement;
    if (right_for_open_sets && declaration.boundary != Declaration::Boundary::closed) {
      judgement.verdict = Verdict::convention;
    } else if (tolerated(truth_.margin, declaration.tolerance, Row::card().margin_degree, question_)) {
      judgement.verdict = Verdict::tolerance;
    } else {
      judgement.verdict = blame(declaration);
    }
    return judgement;
  }

  Judgement judge_yes_or_no(bool answer, const Declaration& declaration) const {
    const std::optional<bool> right = yes_or_no(truth_.answer);
    if (!right) return {Verdict::invalid, 0, "a plain true or false is no answer to this operation"};
    const std::optional<Exactly> open = open_reading();
    const bool right_for_open = open && yes_or_no(*open) == answer;
    Judgement judgement = *right == answer ? Judgement{} : wrong(declaration, right_for_open);
    if (open) judgement.touch_reading = *right == answer ? 1 : right_for_open ? -1 : 0;
    return judgement;
  }

  Judgement judge_answer(const Said& answer, const Declaration& declaration) const {
    const Comparison found = compared(answer, false, declaration.binary32);
    Judgement judgement;
    if (!found.decision) {
      judgement = wrong(declaration, touch_reading(word_of(answer)) == -1);
    } else if (!found.finite) {
      judgement = {Verdict::invalid, found.ulps, "NaN or infinity where the truth is finite"};
    } else if (found.ulps > Row::card().ulps) {
      judgement.verdict = Verdict::inexact;
    }
    judgement.ulps = found.ulps;
    judgement.touch_reading = touch_reading(word_of(answer));
    return judgement;
  }

  static Said read_answer(const Json& json) {
    Said answer{};
    if (Row::card().answer[0] == 0) {
      read(json, "", answer, read_answer_number);
    } else {
      require_fields(json, "", {Row::card().answer});
      if (!json.contains(Row::card().answer)) throw InvalidInput(Row::card().answer, "missing");
      read(json[Row::card().answer], Row::card().answer, answer, read_answer_number);
    }
    return answer;
  }

  Asked question_;
  oracle::Truth<Exactly> truth_;
};

}  // namespace touchstone::audit
