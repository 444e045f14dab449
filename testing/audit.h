// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/counting/audit_run.h"
#include "audit/engines/adapter.h"
#include "audit/engines/serve.h"
#include "testing/asked.h"

/// An audit of an engine inside a test, without a second process: a crash of the engine crashes the test.
///
///   MyEngine engine;                                       // as for TOUCHSTONE_ENGINE_MAIN, see docs/engines.md
///   CHECK(findings(tests::audit(engine, {.operations = {"segment_segment"}, .cases = 5000})) == "");
namespace touchstone::tests {

struct AuditOptions {
  std::vector<std::string> operations{};  ///< by name; empty: all that the engine has
  std::vector<std::string> families{};    ///< empty: all
  std::uint64_t cases = 2000;             ///< per operation, spread over its families in turn
  std::uint64_t seed = 1;
  Sizes sizes = Sizes::any;  ///< ordinary: questions of other sizes are drawn and skipped
};

/// A C++ engine that is asked in this process.
template <class E>
class InProcess final : public audit::Engine {
 public:
  explicit InProcess(E& engine) : served_(audit::served(audit::members_of(engine))) {}
  const catalogue::Declaration& declaration() const override { return served_.hello.declaration; }
  bool supports(const std::string& operation) const override { return served_.operations.count(operation) != 0; }

  /// The operations that the engine has.
  std::vector<std::string> names() const { return {served_.hello.operations.begin(), served_.hello.operations.end()}; }

  void ask_each(const Operation& operation, const std::vector<catalogue::Question>& questions,
                const Take& take) override {
    const audit::Answerer& answerer = served_.operations.at(operation.name()).answer;
    for (std::size_t i = 0; i < questions.size(); ++i) take(i, reply(answerer, questions[i]));
  }

 private:
  static audit::Reply reply(const audit::Answerer& answerer, const catalogue::Question& question) {
    try {
      const auto said = answerer(question);
      if (!said) return {audit::Reply::Kind::unsupported, nullptr, ""};
      // Parsed as if it had come through a pipe: the judge takes numbers as they were written.
      return {audit::Reply::Kind::answered, catalogue::parse_line(catalogue::one_line(*said)), ""};
    } catch (const std::exception& thrown) {
      return {audit::Reply::Kind::failed, nullptr, thrown.what()};
    } catch (...) {
      return {audit::Reply::Kind::failed, nullptr, "an exception that is no std::exception"};
    }
  }

  audit::Served served_;
};

/// The oracle's verdicts on the engine's answers, counted by operation, family and verdict, with the smallest failing
/// input of each. The same options give the same tally. Throws InvalidInput if an operation or a family does not exist,
/// or if the engine does not have the operation.
template <class E>
audit::Tally audit(E& engine, const AuditOptions& options = {}) {
  const InProcess<E> asked(engine);
  audit::AuditOptions all;
  for (const std::string& name : options.operations) {
    if (!asked.supports(name))
      throw InvalidInput("operations", "the engine has no " + name + catalogue::did_you_mean(name, asked.names()));
    all.operations.push_back(catalogue::find_operation(name));
  }
  for (const Operation* operation : catalogue::all_operations()) {
    if (options.operations.empty() && !operation->metadata().is_implementation() && asked.supports(operation->name()))
      all.operations.push_back(operation);
  }
  for (const std::string& family : options.families) {
    const auto has = [&family](const Operation* operation) {
      const auto& names = operation->families();
      return std::find(names.begin(), names.end(), family) != names.end();
    };
    if (std::none_of(all.operations.begin(), all.operations.end(), has))
      throw InvalidInput("families", "no operation asked has a family " + family);
  }
  all.families = options.families;
  all.cases = options.cases;
  all.seed = options.seed;
  all.ordinary_only = options.sizes == Sizes::ordinary;
  all.engine = [&engine] { return std::make_unique<InProcess<E>>(engine); };
  const std::atomic<bool> stop{false};
  return audit::run_audit(all, stop, [](const std::string&, std::uint64_t) {});
}

/// Describes failures, as in "rounding in 12 of 300 cases: the truth is on, it says left", with the best example and
/// the command that repeats it.
inline std::string in_words(const Operation& operation, const audit::Cell& cell, const audit::JudgedOutcome& outcome,
                            const audit::OutcomeCount& count) {
  std::string text = std::string(name_of(outcome.verdict)) + " in " + std::to_string(audit::both(count.cases)) +
                     " of " + std::to_string(cell.cases()) + " cases: truth " + outcome.truth + ", answer " +
                     outcome.answer + '\n';
  if (!count.example) return text;
  const audit::Finding& finding = *count.example;
  if (!finding.judgement.remark.empty()) text += "  " + finding.judgement.remark + '\n';
  if (!finding.answer.is_null()) text += "  it says " + catalogue::one_line(finding.answer) + '\n';
  return text + "  echo '" + catalogue::one_line(operation.print_hexadecimal(finding.question)) +
         "' | touchstone ask " + operation.name() + " -\n";
}

/// Returns "" if an audit found nothing; otherwise a paragraph for each operation, family and kind of failure: how
/// often it failed, an example, the engine's answer, and the command that asks for the truth.
inline std::string findings(const audit::Tally& tally) {
  std::string text;
  for (const audit::OperationTally& operation : tally.operations) {
    const Operation& asked = *catalogue::find_operation(operation.operation);
    for (const auto& [family, cell] : operation.families) {
      for (const auto& [outcome, count] : cell.outcomes) {
        if (catalogue::is_finding(outcome.verdict))
          text += operation.operation + ", " + family + ": " + in_words(asked, cell, outcome, count);
      }
    }
    if (operation.too_much_surplus(tally.max_surplus))
      text += operation.operation + ": more is listed beyond the truth than a broad phase is good for\n";
    if (operation.inconsistent_convention())
      text += operation.operation + ": touch is contact in some answers and not in others\n";
  }
  return text;
}

}  // namespace touchstone::tests
