// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "audit/engines/protocol.h"
#include "audit/engines/question_text.h"
#include "audit/gate/gate.h"
#include "audit/reducing/reduced.h"
#include "audit/reducing/same_finding.h"
#include "c/made.h"
#include "c/options.h"
#include "c/touchstone.h"
#include "catalogue/codec/expected.h"
#include "catalogue/operation/probes/explained.h"
#include "report/screen/table.h"
#include "report/words/phrases.h"
#include "report/words/wording.h"

namespace touchstone::c {
namespace {

using namespace audit;

Reply reply_in(const std::string& text) {
  try {
    Json object = parse_line(text);
    if (!object.is_object()) throw InvalidInput("reply", expected("one JSON object", object));
    Reply reply = read_reply(std::move(object));
    reply.bytes = text.size();
    return reply;
  } catch (const InvalidInput& wrong) {
    return {Reply::Kind::failed, nullptr, wrong.what()};
  }
}

/// A function of the caller as an engine.
class CalledEngine final : public Engine {
 public:
  CalledEngine(Hello hello, touchstone_engine answer, void* user)
      : hello_(std::move(hello)), answer_(answer), user_(user) {}
  const Declaration& declaration() const override { return hello_.declaration; }
  bool supports(const std::string& operation) const override { return hello_.operations.count(operation) > 0; }
  void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override {
    const QuestionText text(operation);
    const std::string name = operation.name();
    std::string line;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      line.clear();
      text.write(questions[i], line);
      const char* const reply = answer_(user_, name.c_str(), line.c_str());
      take(i, reply != nullptr ? reply_in(reply) : Reply{Reply::Kind::failed, nullptr, "not asked", false});
    }
  }

 private:
  Hello hello_;
  touchstone_engine answer_;
  void* user_;
};

std::unique_ptr<Engine> engine_of(const char* greeting, touchstone_engine answer, void* user) {
  if (answer == nullptr) throw InvalidInput("engine", "missing");
  return std::make_unique<CalledEngine>(read_hello(text_of(greeting, "greeting")), answer, user);
}

Json judged_reply(const Operation& operation, const Question& question, const Hello& hello, const Reply& reply) {
  const auto examination = operation.examine(hello.declaration.binary32 ? operation.in_binary32(question) : question);
  const Judgement judgement = judged(reply, *examination, hello.declaration);
  Json line = verdict_json(judgement, kept(reply.answer));
  line["finding"] = is_finding(judgement.verdict);
  line["truth"] = examination->truth();
  if (judgement.verdict == Verdict::agree) return line;
  const Finding finding{examination->question(), judgement, kept(reply.answer)};
  line["why"] = report::why(finding, &operation, report::Speaker::foreign, hello.declaration.binary32);
  return line;
}

Json shrunk_question(const Operation& operation, Question question, std::unique_ptr<Engine> engine, Options options) {
  bool binary32 = false;
  SameFindingOptions same;
  SearchOptions search;
  options.read("binary32", binary32);
  options.read("any_answer", same.any_answer);
  options.read("allow_degenerate", search.allow_degenerate);
  options.require_known();
  std::vector<std::unique_ptr<Engine>> engines;
  if (engine) engines.push_back(std::move(engine));
  const auto asked = engines.empty() ? formula_as_respondent(binary32) : respondent(std::move(engines));
  SameFinding interest(operation, *asked, same);
  question = interest.fitted(question);
  if (const std::string why_not = interest.begin(question); !why_not.empty()) throw InvalidInput("question", why_not);
  const Reduced found = reduced(operation, question, interest, search);
  Json line = Json::object();
  line["input"] = operation.print(found.question);
  line["candidates"] = found.candidates;
  line["finished"] = found.finished;
  return line;
}

/// The exit code of `touchstone audit`.
int exit_code(const Tally& tally, bool failed) {
  return failed ? 1 : report::sum_of(tally.operations).answered() > 0 ? 0 : 2;
}

std::string audited(const char* greeting, touchstone_engine answer, void* user, Options options) {
  AuditOptions run;
  Tally described;
  std::vector<std::string> names, fail_on;
  bool summary = false;
  options.read("ops", names);
  options.read("families", run.families);
  options.read("cases", run.cases);
  options.read("seed", run.seed);
  options.read("by_cost", run.by_cost);
  options.read("ordinary_only", run.ordinary_only);
  options.read("fail_on", fail_on);
  options.read("summary", summary);
  options.read("program", described.repeat.program);
  options.read("options", described.repeat.options);
  options.require_known();
  for (const std::string& name : names) run.operations.push_back(&operation_named(name.c_str()));
  if (names.empty()) run.operations = all_operations();
  Gate gate;
  if (!fail_on.empty()) {
    std::string causes;
    for (const std::string& cause : fail_on) causes += (causes.empty() ? "" : ",") + cause;
    gate.causes = causes_named(causes);
  }
  run.engine = [&] { return engine_of(greeting, answer, user); };
  const std::atomic<bool> never{false};
  Tally tally;
  try {
    tally = run_audit(run, never, [](const std::string&, std::uint64_t) {});
  } catch (const EngineError& none_of_these) {
    throw InvalidInput("greeting", none_of_these.what());
  }
  tally.repeat = described.repeat;
  const GateResult result = held_against(tally, gate);
  std::string table = report::text_table(tally, summary ? report::Detail::operations : report::Detail::all);
  if (!fail_on.empty()) table += gate_in_words(tally, result);
  Json line = Json::object();
  line["exit_code"] = exit_code(tally, fail_on.empty() ? tally.has_findings() : !result.passed());
  line["table"] = table;
  line["tally"] = Json::parse(tally_json(tally));
  return one_line(line);
}

}  // namespace
}  // namespace touchstone::c

using namespace touchstone;
using namespace touchstone::catalogue;

int touchstone_judge(const char* greeting, const char* operation, const char* question, const char* reply,
                     char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    return one_line(c::judged_reply(asked, c::question_of(asked, question),
                                    audit::read_hello(c::text_of(greeting, "greeting")),
                                    c::reply_in(c::text_of(reply, "reply"))));
  });
}

int touchstone_shrink(const char* operation, const char* question, const char* options, const char* greeting,
                      touchstone_engine engine, void* user, char** result, touchstone_error* error) {
  return c::made(result, error, [&] {
    const Operation& asked = c::operation_named(operation);
    return one_line(c::shrunk_question(asked, c::question_of(asked, question),
                                       engine == nullptr ? nullptr : c::engine_of(greeting, engine, user),
                                       c::Options(options)));
  });
}

int touchstone_audit(const char* options, const char* greeting, touchstone_engine engine, void* user, char** result,
                     touchstone_error* error) {
  return c::made(result, error, [&] { return c::audited(greeting, engine, user, c::Options(options)); });
}
