// SPDX-License-Identifier: Apache-2.0
#include "program/commands/recorded/against.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/against/engines_apart.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "catalogue/codec/plain.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/interruptible.h"
#include "program/terminal/progress.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

using Partings = std::vector<audit::PartedOperation>;

/// Time for reducing the smallest question of each kind.
constexpr double usual_seconds_to_reduce = 5;

/// Counts of differing answers by which of the two is right.
struct RightOf {
  std::uint64_t first = 0, second = 0, both = 0, neither = 0;
};

bool is_right(Verdict verdict) { return !is_finding(verdict) && verdict != Verdict::unsupported; }

RightOf right_of(const audit::PartedOperation& operation) {
  RightOf sum;
  for (const auto& [verdicts, kind] : operation.parted) {
    const bool first = is_right(verdicts.first), second = is_right(verdicts.second);
    (first && second ? sum.both : first ? sum.first : second ? sum.second : sum.neither) += kind.count;
  }
  return sum;
}

std::string table(const Partings& partings) {
  std::size_t width = std::string("operation").size();
  for (const audit::PartedOperation& one : partings) width = std::max(width, one.operation.size());
  const auto row = [&](const std::string& name, const std::array<std::string, 6>& cells) {
    std::string line = fmt::format("{:<{}}", name, width);
    for (const std::string& cell : cells) line += fmt::format("{:>14}", cell);
    return line + "\n";
  };
  std::string text = row("operation", {"asked", "differ", "first right", "second right", "both right", "neither"});
  for (const audit::PartedOperation& one : partings) {
    const RightOf right = right_of(one);
    text += row(one.operation, {grouped(one.asked), grouped(one.count()), grouped(right.first), grouped(right.second),
                                grouped(right.both), grouped(right.neither)});
  }
  for (const audit::PartedOperation& one : partings)
    if (one.not_asked > 0)
      text += fmt::format("{}: {} not asked: an engine had been given up, or the run was stopped\n", one.operation,
                          audit::counted(one.not_asked, "question"));
  return text;
}

std::string said(const Json& answer) { return answer.is_null() ? "no answer" : one_line(readable(answer)); }

std::string examples(const Partings& partings) {
  std::string text;
  for (const audit::PartedOperation& one : partings) {
    const Operation& operation = operation_named(one.operation);
    for (const auto& [verdicts, kind] : one.parted) {
      const audit::Parting& shown = *kind.smallest;
      text += fmt::format("\n{}: {} and {}, {}; the smallest:\n", one.operation, name_of(verdicts.first),
                          name_of(verdicts.second), audit::counted(kind.count, "question"));
      text += "  input     " + one_line(operation.print(shown.question)) + "\n";
      text += "  truth     " + one_line(readable(operation.examine(shown.question)->truth())) + "\n";
      text += "  first     " + said(shown.first) + "\n  second    " + said(shown.second) + "\n";
    }
  }
  return text;
}

Json json_of(const Partings& partings) {
  Json operations = Json::array();
  for (const audit::PartedOperation& one : partings) {
    Json kinds = Json::array();
    for (const auto& [verdicts, kind] : one.parted) {
      const audit::Parting& shown = *kind.smallest;
      kinds.push_back({{"first", name_of(verdicts.first)},
                       {"second", name_of(verdicts.second)},
                       {"count", kind.count},
                       {"smallest",
                        {{"input", operation_named(one.operation).print(shown.question)},
                         {"family", shown.family},
                         {"index", shown.index},
                         {"first", plain(shown.first)},
                         {"second", plain(shown.second)}}}});
    }
    operations.push_back(
        {{"operation", one.operation}, {"asked", one.asked}, {"not_asked", one.not_asked}, {"parted", kinds}});
  }
  return {{"touchstone", 1}, {"kind", "against"}, {"operations", operations}};
}

int shown(const Partings& partings, const std::string& first, const std::string& second, const std::string& json_file,
          std::ostream& out, std::ostream& err) {
  std::ostream& readable = is_standard_output(json_file) ? err : out;
  readable << "first: " << first << "\nsecond: " << second << "\n\n" << table(partings) << examples(partings);
  Json json = json_of(partings);
  json["first"] = first, json["second"] = second;
  write_file("--json", json_file, one_line(json) + "\n");
  const bool asked = std::any_of(partings.begin(), partings.end(), [](const auto& one) { return one.asked > 0; });
  if (!asked && !Interruptible::stopped()) throw UsageError("--against: no question was asked that both answer");
  const bool parted = std::any_of(partings.begin(), partings.end(), [](const auto& one) { return one.count() > 0; });
  if (Interruptible::stopped()) return interrupted;
  return parted ? findings : nothing_found;
}

}  // namespace

int audit_against_command(const AuditCommand& command, std::ostream& out, std::ostream& err) {
  if (command.engine.empty()) throw UsageError("--against: expected --engine too, the first of the two");
  require_writable("--json", command.json_file);
  audit::AgainstOptions options;
  options.operations = operations_named(command.operations);
  require_asked_of_engines(options.operations);
  options.cases = command.cases, options.seed = command.seed, options.by_cost = command.by_cost;
  options.jobs = command.jobs > 0 ? command.jobs : audit::jobs_of_machine();
  options.seconds_to_reduce = usual_seconds_to_reduce;
  const std::atomic<bool>& stopped = Interruptible::stopped();
  EngineNotes notes;
  std::string first, second;
  options.engines = [&] {
    audit::EnginePair pair{pipe_engine(command.engine, command.timeout, &stopped, &notes),
                           pipe_engine(command.against, command.timeout, &stopped, &notes)};
    first = pair.first->declaration().engine, second = pair.second->declaration().engine;
    return pair;
  };
  Progress progress(err, is_terminal(Stream::error), options.operations, options.cases);
  if (options.by_cost) progress.ask_by_cost();
  options.progress = [&](const std::string& name, std::uint64_t done) { progress(name, done); };
  Partings partings;
  {
    const Interruptible until_asked;
    partings = ask_against(options, stopped);
  }
  progress.end();
  notes.tell(err);
  return shown(partings, first, second, command.json_file, out, err);
}

int judge_against_command(const JudgeCommand& command, std::ostream& out, std::ostream& err) {
  require_writable("--json", command.json_file);
  audit::AgainstOptions options;
  options.operations = operations_named(command.operations);
  const std::atomic<bool>& stopped = Interruptible::stopped();
  EngineNotes notes;
  std::string second;
  options.engines = [&] {
    audit::EnginePair pair{nullptr, pipe_engine(command.against, command.timeout, &stopped, &notes)};
    second = pair.second->declaration().engine;
    return pair;
  };
  Partings partings;
  {
    const Interruptible until_asked;
    partings = log_against(command.files, options, stopped);
  }
  notes.tell(err);
  return shown(partings, "the log", second, command.json_file, out, err);
}

}  // namespace touchstone::program
