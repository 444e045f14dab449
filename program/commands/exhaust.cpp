// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "audit/engines/notes.h"
#include "audit/place.h"
#include "program/commands/commands.h"
#include "program/commands/grid_run.h"
#include "program/runs/counted_run.h"
#include "report/screen/table.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

/// The configurations of a grid for one job: asked of our reference, or of an engine, many at a time, and of robust.
class Job {
 public:
  using Start = std::function<std::unique_ptr<Engine>()>;
  /// The engine is started on first use.
  Job(const Operation& operation, const ExhaustCommand& command, Start start)
      : operation_(operation), grid_(command.grid), list_length_(command.list_length), start_(std::move(start)) {}

  void examine(const Share& share) {
    if (start_) engine_ = start_(), start_ = nullptr;
    for (std::uint64_t i = share.first; i < share.last; ++i) examine(i);
    ask();
  }
  /// The answers since the last call.
  Cell take_answers() { return std::exchange(answers_, {}); }
  Cell take_robust() { return std::exchange(robust_, {}); }

 private:
  static constexpr std::size_t at_once = 1024;
  struct Pending {
    std::uint64_t index;
    std::unique_ptr<Examination> examination;
  };

  void examine(std::uint64_t i) {
    const Question question = operation_.on_grid(grid_, i, list_length_);
    try {
      auto examination = operation_.examine(question);
      count(robust_, {operation_, question, examination->outcome(), i}, examination->judge_robust());
      add(i, question, std::move(examination));
    } catch (const InvalidInput& refused) {
      answers_.refuse(refused.rule());
      robust_.refuse(refused.rule());
      const std::string mismatch = operation_.refusal_mismatch(question);
      if (!mismatch.empty()) count(robust_, {operation_, question, "refused", i}, {Verdict::invalid, 0, mismatch, 0});
    }
  }

  void add(std::uint64_t index, const Question& question, std::unique_ptr<Examination> examination) {
    if (engine_ == nullptr) {
      count(answers_, {operation_, question, examination->outcome(), index}, examination->judge_reference());
      return;
    }
    pending_.push_back({index, std::move(examination)});
    questions_.push_back(question);
    if (pending_.size() == at_once) ask();
  }

  void ask() {
    if (pending_.empty()) return;
    std::vector<JudgedReply> replies(pending_.size());
    engine_->ask_each(operation_, questions_, [&](std::size_t i, const Reply& reply) {
      replies[i] = judged_and_kept(reply, *pending_[i].examination, engine_->declaration());
    });
    for (std::size_t i = 0; i < pending_.size(); ++i) {
      const auto& [judgement, answer, asked] = replies[i];
      if (asked) {
        count(answers_, {operation_, questions_[i], pending_[i].examination->outcome(), pending_[i].index}, judgement,
              answer);
      } else {
        ++answers_.not_asked;
        answers_.given_up = judgement.remark;
      }
    }
    pending_.clear();
    questions_.clear();
  }

  const Operation& operation_;
  int grid_;
  std::size_t list_length_;
  Start start_;
  std::unique_ptr<Engine> engine_;
  Cell answers_, robust_;
  std::vector<Pending> pending_;
  std::vector<Question> questions_;
};

int examinations(const Operation& operation, const ExhaustCommand& command, const Shard& shard, std::ostream& out,
                 std::ostream& err) {
  GridRun run(operation, command, shard, err);
  EngineNotes notes;
  const auto start = [&] { return engine_for(operation, command.engine, command.timeout, notes); };
  const std::unique_ptr<Engine> first = start();  // reports its defects before anything is asked
  Tally tally;
  tally.declaration = first != nullptr ? first->declaration() : reference_declaration();
  tally.cases = run.total();
  tally.grid = {static_cast<std::uint64_t>(command.grid), shard.of, {shard.index}};
  const std::string family = fmt::format("{0}-grid", command.grid);
  tally.operations.push_back({operation.name(), {{family, {}}}});
  tally.robust = tally.operations;
  Cell &answers = tally.operations[0].families[0].second, &robust = tally.robust[0].families[0].second;
  if (const Json counted = run.counted(); !counted.is_null()) {
    const Tally stopped = read_tally(counted.get<std::string>());
    answers.merge(stopped.operations.at(0).families.at(0).second);
    robust.merge(stopped.robust.at(0).families.at(0).second);
  }
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < run.jobs(); ++i) jobs.emplace_back(operation, command, start);
  const auto take = [&] {
    for (Job& job : jobs) answers.merge(job.take_answers()), robust.merge(job.take_robust());
  };
  const bool finished = run.run([&](std::size_t job, const Share& share) { jobs[job].examine(share); },
                                [&] { return take(), Json(tally_json(tally)); });
  take();
  notes.tell(err);
  if (!finished) return interrupted;
  tally.repeat = repeat_of(command.program, command.engine, command.timeout);
  (is_standard_output(command.json_file) ? err : out) << text_table(tally);
  write_file("--json", command.json_file, tally_json(tally));
  run.finish();
  if (tally.has_findings()) return findings;
  if (shard.of > 1 || sum_of(tally.operations).cases() > 0) return nothing_found;  // one of many shards may be empty
  err << "touchstone: nothing was judged: no configuration on this grid is within the contract\n";
  return bad_usage;
}

Counts counted(const Operation& operation, const ExhaustCommand& command, const Share& share) {
  const auto decided = operation.count_decisions(command.grid, share.first, share.last, command.list_length);
  Counts counts{operation.name(), {share}, decided->outcomes, decided->of_grid, decided->wrong, decided->hash, nullptr};
  if (decided->wrong > 0)
    counts.first_wrong = {
        {"index", decided->first_wrong},
        {"input", operation.print(operation.on_grid(command.grid, decided->first_wrong, command.list_length))}};
  return counts;
}

int decisions(const Operation& operation, const ExhaustCommand& command, const Shard& shard, std::ostream& out,
              std::ostream& err) {
  if (operation.row().count_decisions == nullptr) {
    std::string names;
    for (const Operation* other : all_operations())
      if (other->row().count_decisions != nullptr) names += (names.empty() ? "" : ", ") + other->name();
    throw UsageError("--decisions: expected an operation with a fast pair of decisions (" + names + ")");
  }
  GridRun run(operation, command, shard, err);
  CountedRun sum;
  sum.kind = "decisions";
  sum.grid = static_cast<std::uint64_t>(command.grid);
  sum.of = run.total();
  sum.shards = shard.of;
  sum.done = {shard.index};
  sum.operations.push_back({operation.name(), {}, {}, {}, 0, 0, nullptr});
  if (const Json stopped = run.counted(); !stopped.is_null()) sum = read_counted_run(stopped);
  std::vector<Counts> pieces(run.jobs());
  const auto take = [&] {
    for (Counts& piece : pieces) sum.operations[0].add(std::exchange(piece, {}));
  };
  const bool finished =
      run.run([&](std::size_t job, const Share& share) { pieces[job].add(counted(operation, command, share)); },
              [&] { return take(), json_of(sum); });
  take();
  if (!finished) return interrupted;
  require_full_grid(sum);
  const std::string line = one_line(json_of(sum)) + "\n";
  if (!is_standard_output(command.json_file)) out << line;
  write_file("--json", command.json_file, line);
  run.finish();
  return sum.wrong() > 0 ? findings : nothing_found;
}

}  // namespace

int exhaust_command(const ExhaustCommand& asked, std::ostream& out, std::ostream& err) {
  ExhaustCommand command = asked;
  const Operation& operation = operation_named(command.operation);
  if (command.list_length == 0) {
    command.list_length = operation.metadata().list_length;
  } else if (operation.metadata().list_length == 0 || operation.row().world) {
    throw UsageError("--list-length: expected an operation that is asked about lists of numbers on a plain grid");
  }
  const Shard shard = shard_of(command.shard);
  require_writable("--json", command.json_file);
  if (command.decisions && !command.engine.empty())
    throw UsageError("--decisions cannot be combined with --engine: an engine returns full answers");
  tell(shard, err);
  const auto run = command.decisions ? decisions : examinations;
  return run(operation, command, shard, out, err);
}

}  // namespace touchstone::program
