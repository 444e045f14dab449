// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/same_finding.h"

#include <algorithm>
#include <cctype>
#include <new>

#include "audit/counting/judged.h"
#include "catalogue/codec/plain.h"
#include "catalogue/judge/compare.h"
#include "catalogue/operation/probes/fitted.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

constexpr std::uint64_t most_steps = std::uint64_t{1} << 22, most_exact_steps = std::uint64_t{1} << 16;

class Engines final : public Respondent {
 public:
  explicit Engines(std::vector<std::unique_ptr<Engine>> engines) : engines_(std::move(engines)) {}
  const Declaration& declaration() const override { return engines_[0]->declaration(); }
  Reply reply(std::size_t job, const Operation& operation, const Question& question) override {
    return engines_[job]->ask(operation, {question})[0];
  }
  Judgement judgement(const Reply& reply, const Examination& examination) const override {
    return judged(reply, examination, declaration());
  }

 private:
  std::vector<std::unique_ptr<Engine>> engines_;
};

class Formula final : public Respondent {
 public:
  explicit Formula(bool binary32) : declaration_(reference_declaration()) {
    declaration_.binary32 = binary32;
    if (binary32) declaration_.engine += " in float";
  }
  const Declaration& declaration() const override { return declaration_; }
  Reply reply(std::size_t, const Operation& operation, const Question& question) override {
    const RowFunctions& row = operation.row();
    Reply reply;
    const EncodedValue<double> answer =
        declaration_.binary32 ? in_doubles(row.reference_tracked.ask(question, true)) : row.reference(question);
    // As if it had come through a pipe: numbers are parsed as they are written.
    reply.answer = parse_line(one_line(operation.answer_json(answer)));
    return reply;
  }
  Judgement judgement(const Reply&, const Examination& examination) const override {
    return examination.judge_reference(declaration_.binary32);
  }

 private:
  Declaration declaration_;
};

std::vector<std::string> parts_of_outcome(const std::string& outcome) {
  std::vector<std::string> parts(1);
  for (const char c : outcome) {
    if (c == '/') parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

/// If an answer has as many enumerators as the truth, those that differ: "disjoint, not touching; ".
std::string difference(const std::string& truth, const std::string& answer) {
  const std::vector<std::string> right = parts_of_outcome(truth), said = parts_of_outcome(answer);
  if (right.size() != said.size()) return answer + ", not " + truth;
  std::string text;
  for (std::size_t i = 0; i < right.size(); ++i)
    if (right[i] != said[i]) text += std::to_string(i) + ": " + said[i] + ", not " + right[i] + "; ";
  return text;
}

}  // namespace

std::unique_ptr<Respondent> respondent(std::vector<std::unique_ptr<Engine>> engines) {
  return std::make_unique<Engines>(std::move(engines));
}
std::unique_ptr<Respondent> formula_as_respondent(bool binary32) { return std::make_unique<Formula>(binary32); }

bool steps_too_many(const Operation& operation, const Question& question) {
  const Time& time = operation.metadata().time;
  const std::uint64_t n = elements_of_lists(*operation.row().question, question);
  return steps_of(time.oracle, n) > most_steps || steps_of(time.reference, n) > most_exact_steps;
}

std::string reason_of(const std::string& remark) {
  if (remark.starts_with("exit code ") || remark.starts_with("signal ")) return remark.substr(0, remark.find(':'));
  std::string reason;
  for (const char c : remark) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!digit) reason += c;
    else if (reason.empty() || reason.back() != '0') reason += '0';
  }
  return reason;
}

SameFinding::SameFinding(const Operation& operation, Respondent& respondent, const SameFindingOptions& options)
    : operation_(operation), respondent_(respondent), options_(options) {}

Question SameFinding::fitted(const Question& question) const {
  const Declaration& declaration = respondent_.declaration();
  const bool of_formula = declaration.engine.starts_with("reference");
  if (of_formula) return declaration.binary32 ? operation_.in_binary32(question) : question;
  return catalogue::fitted(operation_, question, declaration);
}

SameFinding::Target SameFinding::failure(const Reply& reply) {
  return {name_of(Verdict::invalid), reason_of(reply.remark), true, ""};
}

bool SameFinding::matches(const Target& found) const {
  const bool same_words = found.difference == target_.difference;
  if (target_.cause.empty()) return same_words;
  return found.cause == target_.cause && found.reason == target_.reason && (options_.any_answer || same_words);
}

std::optional<SameFinding::Target> SameFinding::against_robust(const Json& answer,
                                                               const EncodedValue<double>& robust) const {
  const RowFunctions& row = operation_.row();
  const std::string truth = outcome_of(*row.answer, robust.words);
  std::string said;
  if (answer.is_boolean()) {
    if (yes_or_no(*row.answer, robust.words) == answer.get<bool>()) return std::nullopt;
    said = answer.get<bool>() ? "true" : "false";
  } else {
    try {
      const std::string name = row.metadata->answer;
      const bool partial = row.defect == nullptr;
      EncodedValue<double> encoded;
      read_json(*row.answer, name.empty() ? answer : answer.at(name), "answer", encoded, read_answer_number, partial);
      said = outcome_of(*row.answer, encoded.words, partial);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }
  if (said == truth) return std::nullopt;
  return Target{"", "", false, difference(truth, said)};
}

std::optional<SameFinding::Target> SameFinding::examined(const Question& question, const Reply& reply) const {
  const auto examination = operation_.examine(question);
  const Judgement judgement = respondent_.judgement(reply, *examination);
  if (!is_shown(judgement)) return std::nullopt;
  const bool invalid = judgement.verdict == Verdict::invalid;
  const JudgedOutcome outcome = judged_outcome(judgement, examination->outcome());
  return Target{cause_of(judgement), invalid ? reason_of(judgement.remark) : "", false,
                invalid ? "" : difference(outcome.truth, outcome.answer)};
}

std::string SameFinding::begin(const Question& question) {
  const Reply reply = respondent_.reply(0, operation_, question);
  const std::string& name = respondent_.declaration().engine;
  if (reply.kind == Reply::Kind::unsupported) return name + " does not answer it";
  if (reply.kind == Reply::Kind::failed) {
    if (!options_.allow_invalid) operation_.row().robust(question, 0);  // refuses questions outside the contract
    target_ = failure(reply);
    return "";
  }
  const EncodedValue<double> robust = operation_.row().robust(question, 0);
  auto found = steps_too_many(operation_, question) ? against_robust(reply.answer, robust) : std::nullopt;
  if (!found) found = examined(question, reply);
  if (!found) return name + " is right on it";
  target_ = *found;
  return "";
}

Look SameFinding::look(std::size_t job, const Question& question) {
  try {
    EncodedValue<double> robust;
    if (!options_.allow_invalid) robust = operation_.row().robust(question, 0);
    const Reply reply = respondent_.reply(job, operation_, question);
    if (!reply.asked || reply.kind == Reply::Kind::unsupported) return Look::fails;
    const bool failed = reply.kind == Reply::Kind::failed;
    if (failed || target_.no_answer) return failed && matches(failure(reply)) ? Look::holds : Look::fails;
    if (plain(reply.answer) == operation_.answer_json(robust)) return Look::fails;
    const bool by_robust = target_.cause.empty() && steps_too_many(operation_, question);
    const auto found = by_robust ? against_robust(reply.answer, robust) : examined(question, reply);
    return found && matches(*found) ? Look::holds : Look::fails;
  } catch (const InvalidInput&) {
    return Look::refused;
  } catch (const std::bad_alloc&) {
    return Look::fails;
  }
}

void SameFinding::go_on_with(const Question& question) {
  if (!target_.cause.empty() || steps_too_many(operation_, question)) return;
  const auto found = examined(question, respondent_.reply(0, operation_, question));
  if (found) target_ = *found;
}

}  // namespace touchstone::audit
