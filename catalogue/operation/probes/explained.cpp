// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/explained.h"

#include "catalogue/operation/judgement.h"
#include "catalogue/operation/operation.h"
#include "oracle/certificates/check.h"

namespace touchstone::catalogue {

Json certificate_json(const oracle::Certificate& certificate) {
  Json result = Json::object();
  result["kind"] = certificate.kind;
  for (const auto& [name, values] : certificate.facts) {
    Json list = Json::array();
    for (const oracle::Rational& value : values) list.push_back(written(value));
    result[name] = std::move(list);
  }
  for (const auto& [name, proofs] : certificate.parts) {
    Json list = Json::array();
    for (const oracle::Certificate& proof : proofs) list.push_back(certificate_json(proof));
    result[name] = std::move(list);
  }
  return result;
}

Json verdict_json(const Judgement& judgement, Json answer) {
  Json result = Json::object();
  result["answer"] = std::move(answer);
  switch (judgement.verdict) {
    case Verdict::rounding:
    case Verdict::algorithm:
      result["verdict"] = "wrong";
      result["cause"] = name_of(judgement.verdict);
      break;
    default: result["verdict"] = name_of(judgement.verdict);
  }
  const bool wrong = judgement.verdict == Verdict::rounding || judgement.verdict == Verdict::algorithm;
  if (judgement.ulps > 0 && (!wrong || judgement.number)) {
    result["ulps"] = written(judgement.ulps);
  }
  if (!judgement.remark.empty()) result["remark"] = judgement.remark;
  return result;
}

namespace {

/// `ask` does not evaluate a formula with more steps, nor determine the cause of an error that takes more: that
/// evaluates the formula again in exact arithmetic, where a step takes a hundred times as long or more. Measured in
/// steps, so that the same question gets the same bytes.
constexpr std::uint64_t most_steps = std::uint64_t{1} << 24, most_exact_steps = std::uint64_t{1} << 16;

/// The formula's steps in words if they are more than `most`; "" otherwise.
std::string steps_beyond(std::uint64_t most, const Examination& examination) {
  const std::uint64_t n = elements_of_lists(*examination.row().question, examination.question());
  const Growth growth = examination.operation().metadata().time.reference;
  const std::uint64_t steps = steps_of(growth, n);
  if (steps <= most) return "";
  return std::to_string(steps) + " steps (" + name_of(growth) + ", n = " + std::to_string(n) + ")";
}

/// The textbook formula's answer, and the verdict on it, as far as the steps allow.
Json reference_json(const Examination& examination) {
  if (const std::string steps = steps_beyond(most_steps, examination); !steps.empty())
    return Json::object({{"not_evaluated", steps}});
  const std::string steps = too_many_for_a_cause(examination);
  if (steps.empty() || !formula_errs(examination))
    return verdict_json(examination.judge_reference(), examination.reference());
  return Json::object({{"answer", examination.reference()}, {"verdict", "wrong"}, {"cause_not_evaluated", steps}});
}

}  // namespace

std::string too_many_for_a_cause(const Examination& examination) { return steps_beyond(most_exact_steps, examination); }

Json truth_of_decimals(const Operation& operation, const Json& printed) {
  try {
    return operation.truth_as_typed(parse_line(one_line(printed)));
  } catch (const InvalidInput&) {
    return nullptr;
  }
}

Json truth_alone(const Examination& examination) {
  const Operation& operation = examination.operation();
  Json line = Json::object();
  line["op"] = operation.name();
  line["input"] = operation.print(examination.question());
  line["truth"] = examination.truth();
  if (examination.margin()) line["margin"] = written(*examination.margin());
  return line;
}

Json explained(const Examination& examination) {
  const Operation& operation = examination.operation();
  Json line = truth_alone(examination);
  line["certificate"] = certificate_json(examination.certificate());
  line["robust"] = verdict_json(examination.judge_robust(), examination.robust());
  line["reference"] = reference_json(examination);
  for (const Operation* other : all_operations()) {
    if (operation.name() != other->metadata().implementation_of) continue;
    const Examination by_other(*other, examination);
    const bool longer = other->name().starts_with(operation.name() + "_");
    line["reference_" + (longer ? other->name().substr(operation.name().size() + 1) : other->name())] =
        reference_json(by_other);
  }
  return line;
}

nlohmann::json claim_of(const Examination& examination) {
  return {{"op", examination.operation().name()},
          {"input", examination.operation().print(examination.question())},
          {"truth", examination.truth()},
          {"certificate", certificate_json(examination.certificate())}};
}

std::string certificate_complaint(const Examination& examination) {
  const auto refused = certify::refuse(claim_of(examination));
  return refused ? "the checker refuses the oracle's certificate: " + *refused : "";
}

}  // namespace touchstone::catalogue
