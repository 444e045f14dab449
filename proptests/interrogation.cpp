// SPDX-License-Identifier: Apache-2.0
#include "proptests/interrogation.h"

#include <algorithm>
#include <bit>

#include "catalogue/operation/judgement.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/operation/probes/symmetries.h"
#include "proptests/any_robust_bits.h"

namespace touchstone::proptests {
namespace {

using catalogue::EncodedValue;
using catalogue::Examination;
using catalogue::Operation;
using catalogue::Question;
using catalogue::StageFunctions;
using catalogue::Verdict;
using robust::Stage;

std::string in_words(std::size_t environment) { return " (" + environment_name(environment) + ")"; }

bool same_bits(const EncodedValue<double>& a, const EncodedValue<double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return a.words == b.words && std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(), same);
}

std::string other_refusal(const Operation& operation, const Question& question, const InvalidInput& by_oracle) {
  for (const std::size_t environment : {std::size_t{0}, environment_of(question)}) {
    std::string said = "an answer";
    try {
      operation.row().robust(question, environment);
    } catch (const InvalidInput& refused) {
      said = refused.what();
    }
    if (said != by_oracle.what())
      return std::string("refusal: that of the oracle is ") + by_oracle.what() + ", robust gives " + said +
             in_words(environment);
  }
  return "";
}

std::string wrong_robust(const Examination& question) {
  const catalogue::Judgement& judged = question.judge_robust();
  if (judged.verdict != Verdict::agree) {
    return std::string("robust: ") + name_of(judged.verdict) + " " + judged.remark + ", it answers " +
           catalogue::one_line(question.robust()) + ", the truth is " + catalogue::one_line(question.truth());
  }
  const std::string residual = catalogue::residual_complaint(question);
  if (!residual.empty()) return "robust: " + residual;
  const std::size_t other = environment_of(question.question());
  const bool decides = question.row().decision != nullptr;
  const bool same = same_bits(question.robust_answer(other), question.robust_answer()) &&
                    (!decides || question.robust_decision(other) == question.robust_decision());
  return same ? "" : "robust: it answers differently in another environment" + in_words(other);
}

/// What is wrong with some stage; the stage that decides is never later than the first that knows.
std::string wrong_stage(const StageFunctions& stages, const Question& question, std::size_t environment,
                        const EncodedValue<double>& answer) {
  const Stage decided = stages.decided_by == nullptr ? Stage::filter : stages.decided_by(question, environment);
  for (const StageFunctions::One& one : stages.each) {
    const std::string name = "stage " + std::to_string(static_cast<int>(one.stage)) + ": ";
    const auto found = one.ask(question, environment);
    if (found && *found != answer) return name + "it is not the answer";
    if (found && decided > one.stage) return name + "it knows the answer, but a later one decided";
    if (!found && one.stage == Stage::exact) return name + "it must always know";
  }
  return "";
}

std::string wrong_stages(const Examination& question) {
  const catalogue::RowFunctions& row = question.row();
  for (const std::size_t environment : {std::size_t{0}, environment_of(question.question())}) {
    std::string found = wrong_stage(row.stages, question.question(), environment, question.robust_answer(environment));
    if (found.empty() && row.decision != nullptr) {
      const EncodedValue<double> decision{{}, {question.robust_decision(environment)}};
      found = wrong_stage(row.decision_stages, question.question(), environment, decision);
    }
    if (!found.empty()) return found + in_words(environment);
  }
  return "";
}

std::string wrong_promise(const Examination& question) {
  const std::string broken = catalogue::broken_promise(question);
  if (!broken.empty()) return "promise: " + broken;
  // Of numbers that a checker refuses, as slabs that lose a point, no comparison tells.
  const bool numbers_refused = question.row().defect != nullptr && !question.formula().numbers.empty();
  const catalogue::Judgement& judgement = question.judge_reference();
  if (judgement.verdict == Verdict::rounding && !judgement.number && !question.inconclusive() && !numbers_refused)
    return "promise: the reference is wrong by rounding where rounding cannot have changed its decision";
  return "";
}

std::string with_name(const char* aspect, const std::string& complaint) {
  return complaint.empty() ? "" : aspect + complaint;
}

std::string wrong_law_of_robust(const Examination& question) {
  const Operation& operation = question.operation();
  const catalogue::Answering<double> robust = [&](const Question& image) {
    return same_bits(image, question.question()) ? question.robust_answer() : operation.row().robust(image, 0);
  };
  return with_name("law of robust: ", catalogue::broken_law(operation, question.question(), robust,
                                                            operation.answer_shape(), catalogue::Compared::everything));
}

std::string wrong_law_of_oracle(const Examination& question) {
  const Operation& operation = question.operation();
  const catalogue::Answering<catalogue::TrueNumber> oracle = [&](const Question& image) {
    return same_bits(image, question.question()) ? question.solution().answer : operation.row().solve(image).answer;
  };
  return with_name("law of the oracle: ", catalogue::broken_law(operation, question.question(), oracle));
}

std::string wrong(const Examination& question, Aspect aspect) {
  switch (aspect) {
    case Aspect::robust: return wrong_robust(question);
    case Aspect::stages: return wrong_stages(question);
    case Aspect::promise: return wrong_promise(question);
    case Aspect::certificate: return with_name("certificate: ", catalogue::certificate_complaint(question));
    case Aspect::laws_of_robust: return wrong_law_of_robust(question);
    case Aspect::laws_of_oracle: return wrong_law_of_oracle(question);
  }
  return "";
}

}  // namespace

Aspects aspects_of(const Operation& operation) {
  Aspects aspects;
  const auto set = [&](Aspect aspect, bool asked) { aspects[static_cast<std::size_t>(aspect)] = asked; };
  const bool own_truth = !operation.metadata().is_implementation(), laws = catalogue::declares_laws(operation);
  set(Aspect::robust, true);
  set(Aspect::stages, !operation.row().stages.each.empty());
  set(Aspect::promise, true);
  set(Aspect::certificate, own_truth);
  set(Aspect::laws_of_robust, laws);
  set(Aspect::laws_of_oracle, laws);
  return aspects;
}

std::string interrogated(const Operation& operation, const Question& question, const Aspects& aspects) {
  std::unique_ptr<Examination> examined;
  try {
    examined = operation.examine(question);
  } catch (const InvalidInput& refused) {
    return has(aspects, Aspect::robust) ? other_refusal(operation, question, refused) : "";
  }
  try {
    for (std::size_t i = 0; i < aspect_count; ++i) {
      const std::string found = aspects[i] ? wrong(*examined, static_cast<Aspect>(i)) : "";
      if (!found.empty()) return found;
    }
  } catch (const InvalidInput& refused) {
    return std::string("robust: it refuses what the oracle answers: ") + refused.what();
  }
  return "";
}

}  // namespace touchstone::proptests
