// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "audit/counting/audit_run.h"
#include "audit/counting/easy_questions.h"
#include "audit/engines/pipe.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/plain.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

constexpr std::size_t most_shown = 400;

std::string shown(const Json& value) { return excerpt(one_line(value), most_shown); }

bool is_wrong(Verdict verdict) { return is_finding(verdict) || verdict == Verdict::tolerance; }

/// The engine's answers to the easy questions of one operation.
struct Connection {
  struct Wrong {
    Json input, expected, got;
    Judgement judgement;
  };
  std::size_t asked = 0, right = 0, declined = 0;
  std::vector<Wrong> wrong;
  std::map<std::string, std::string> said;  ///< truth's enumerator -> the answer's; empty if that varies
};

Connection connection_of(Engine& engine, const Operation& operation) {
  Connection connection;
  const std::vector<EasyQuestion> easy = easy_questions(operation, engine.declaration());
  std::vector<Question> questions;
  for (const EasyQuestion& one : easy) questions.push_back(one.question);
  const std::vector<Reply> replies = engine.ask(operation, questions);
  for (std::size_t i = 0; i < easy.size(); ++i) {
    const Examination& examination = *easy[i].examination;
    const Judgement judgement = judged(replies[i], examination, engine.declaration());
    ++connection.asked;
    if (judgement.verdict == Verdict::unsupported) {
      ++connection.declined;
      continue;
    }
    if (is_wrong(judgement.verdict)) {
      connection.wrong.push_back(
          {operation.print(easy[i].question), examination.rounded_truth(), kept(replies[i].answer), judgement});
    } else {
      ++connection.right;
    }
    const auto [entry, is_new] = connection.said.emplace(examination.outcome(), judgement.said);
    if (!is_new && entry->second != judgement.said) entry->second.clear();
  }
  return connection;
}

/// "left is said for right, right is said for left", if every answer is right except that names are exchanged.
std::string exchanged_names(const Connection& connection) {
  std::string text;
  for (const auto& [truth, said] : connection.said) {
    if (said.empty() || said == "value") return "";
    if (said == truth) continue;
    const auto back = connection.said.find(said);
    if (back == connection.said.end() || back->second != truth) return "";
    text += (text.empty() ? "" : ", ") + said + " is said for " + truth;
  }
  return text;
}

/// The answers have the right form, but some are wrong: a bug of the engine, not of its connection.
bool is_connected(const Connection& connection) {
  const bool malformed = std::any_of(connection.wrong.begin(), connection.wrong.end(), [](const auto& wrong) {
    return wrong.judgement.verdict == Verdict::invalid || wrong.judgement.verdict == Verdict::tolerance;
  });
  const bool constant =
      connection.said.size() > 1 && std::all_of(connection.said.begin(), connection.said.end(), [&](const auto& entry) {
        return !entry.second.empty() && entry.second != "value" && entry.second == connection.said.begin()->second;
      });
  const bool numbers_alone = std::all_of(connection.wrong.begin(), connection.wrong.end(),
                                         [](const auto& wrong) { return wrong.judgement.number.has_value(); });
  const bool some_right = connection.right > 0 && !constant && exchanged_names(connection).empty();
  return connection.wrong.empty() || (!malformed && (some_right || numbers_alone));
}

std::string why(const Connection& connection) {
  const Connection::Wrong& first = connection.wrong[0];
  if (!first.judgement.remark.empty()) return first.judgement.remark;
  const std::string exchanged = exchanged_names(connection);
  if (!exchanged.empty()) return exchanged + ": is the order of the arguments, or a sign, another one?";
  if (first.judgement.number) return "a number is off: " + off_in_words(first.judgement);
  if (first.judgement.verdict == Verdict::tolerance)
    return "wrong, and excused by a tolerance that is greater than whole shapes";
  return "another answer than the definition gives, at small numbers and far from any touch";
}

void tell(const Operation& operation, const Connection& connection, std::ostream& out) {
  out << fmt::format("{:<32} {} of {} right", operation.name(), connection.right, connection.asked);
  if (connection.declined > 0) out << fmt::format(", {} not supported", connection.declined);
  out << '\n';
  if (connection.wrong.empty()) return;
  const Connection::Wrong& first = connection.wrong[0];
  out << "  input     " << shown(first.input) << "\n  expected  " << shown(first.expected) << "\n  got       "
      << (first.got.is_null() ? "no answer" : shown(readable(first.got))) << "\n  why       "
      << excerpt(why(connection), most_shown) << '\n';
}

}  // namespace

int check_engine_command(const CheckEngineCommand& command, std::ostream& out, std::ostream& err) {
  EngineNotes notes;
  PipeLimits limits;
  limits.timeout = command.timeout;
  limits.start_timeout = 2 * command.timeout;
  limits.timeouts = 1;  // an engine that times out once is not connected
  limits.restarts_in_a_row = 2;
  PipeEngine engine(command.engine, limits, nullptr, &notes);
  const Declaration& declared = engine.declaration();
  std::size_t operations = 0, wrong = 0, apart = 0, unchecked = 0;
  out << subject(declared) << ", boundary " << boundary_word(declared.boundary) << ", tolerance "
      << decimal(declared.tolerance) << '\n';
  for (const Operation* operation : all_operations()) {
    if (!engine.supports(operation->name())) continue;
    const Connection connection = connection_of(engine, *operation);
    tell(*operation, connection, out);
    ++operations;
    wrong += connection.wrong.empty() ? 0 : 1;
    apart += is_connected(connection) ? 0 : 1;
    unchecked += connection.declined == connection.asked ? 1 : 0;
  }
  if (operations == 0)
    throw EngineError("engine " + declared.engine + ": it declares none of the operations" + notes.of_first_line());
  notes.tell(err);
  if (apart > 0) out << fmt::format("not connected: {} of {}\n", apart, counted(operations, "operation"));
  else out << fmt::format("connected: {}\n", counted(operations - unchecked, "operation"));
  if (wrong > apart)
    out << fmt::format("connected, and wrong at an easy question: {}; touchstone audit says where else\n",
                       counted(wrong - apart, "operation"));
  if (unchecked > 0)
    out << fmt::format("not checked: {}, of which no easy question is supported\n", counted(unchecked, "operation"));
  return wrong == 0 && unchecked == 0 ? nothing_found : findings;
}

}  // namespace touchstone::program
