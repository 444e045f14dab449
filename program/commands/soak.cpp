// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "audit/counted.h"
#include "audit/counting/judged.h"
#include "audit/parallel.h"
#include "audit/place.h"
#include "audit/platform.h"
#include "audit/time_limit.h"
#include "catalogue/judge/environment.h"
#include "program/commands/commands.h"
#include "program/runs/checkpoint.h"
#include "program/runs/counted_run.h"
#include "program/runs/rounds.h"
#include "program/terminal/interruptible.h"
#include "program/terminal/progress.h"

namespace touchstone::program {
namespace {

/// The length of an operation's turn in seconds: short runs reach every operation, too.
constexpr double turn = 0.25;

/// Questions to robust and the oracle alone. If the oracle has a quick decision, decisions are compared, and about
/// every 16th answer in full; half of the answers are computed in any of the floating-point environments.
class Soaked {
 public:
  Soaked(const Operation& operation, std::uint64_t seed) : operation_(operation), seed_(seed) {}

  Counts count(const Share& share) const {
    Counts counts{operation_.name(), {share}, {}, {}, 0, 0, nullptr};
    for (std::uint64_t index = share.first; index < share.last; ++index) {
      const std::size_t families = operation_.families().size(), family = index % families;
      DrawStream draws = case_draws(operation_, family, seed_, index / families);
      const Question question = operation_.draw(draws, family);
      const std::uint64_t hash = seed_of(seed_, "environment", index);
      const std::size_t environment = hash % 2 == 0 ? 0 : hash / 2 % environment_count;
      std::string outcome;
      const std::string wrong = difference(question, environment, hash / 32 % 16 == 0, outcome);
      ++counts.outcomes[outcome];
      counts.hash += seed_of(index, (outcome + wrong).c_str(), 0);
      if (!wrong.empty() && ++counts.wrong == 1) {
        counts.first_wrong = {{"index", index},
                              {"family", operation_.families()[family]},
                              {"input", operation_.print(question)},
                              {"remark", wrong + " (" + environment_name(environment) + ")"}};
      }
    }
    return counts;
  }

 private:
  /// "" if there is none.
  std::string difference(const Question& question, std::size_t environment, bool in_batch, std::string& outcome) const {
    const RowFunctions& row = operation_.row();
    try {
      if (row.decide_by_oracle != nullptr) {
        const Word truth = row.decide_by_oracle(question);
        outcome = row.decision->words[truth];
        if (row.decide(question, environment) != truth) return "another decision";
        if (!in_batch) return "";
      }
      const std::unique_ptr<Examination> examination = operation_.examine(question);
      if (outcome.empty()) outcome = examination->outcome();
      const Judgement judgement = examination->judge_robust(environment);
      return judgement.verdict == Verdict::agree ? "" : name_of(judgement.verdict) + (" " + judgement.remark);
    } catch (const InvalidInput&) {
      outcome = "refused";
      return operation_.refusal_mismatch(question, environment);
    }
  }

  const Operation& operation_;
  std::uint64_t seed_;
};

/// One shard of a soak: the operations take turns, until each has asked its share or the time is over.
class Soak {
 public:
  Soak(const SoakCommand& command, const Shard& shard) : seconds_(command.seconds) {
    jobs_ = command.jobs > 0 ? command.jobs : jobs_of_machine();
    run_.kind = "soak";
    run_.seed = command.seed;
    run_.seconds = command.seconds;
    run_.of = command.cases;
    run_.shards = shard.of;
    run_.done = {shard.index};
    share_ = share_of(run_.of, shard);
    for (const Operation* operation : operations_named(command.operations)) {
      operations_.push_back(operation);
      run_.operations.push_back({operation->name(), {}, {}, {}, 0, 0, nullptr});
      rounds_.emplace_back(jobs_, turn);
    }
  }

  void go_on_from(const Json& state) {
    run_ = read_counted_run(Place{state, "state"}.at("run").value);
    spent_ = Place{state, "state"}.at("spent").number();
    before_ = asked();
  }
  Json state() const { return {{"run", json_of(run_)}, {"spent", spent_ + time()}}; }

  /// Returns false if it was interrupted.
  bool run(Checkpoint& checkpoint, Progress& progress) {
    for (bool left = true; left;) {
      left = false;
      for (std::size_t i = 0; i < operations_.size(); ++i) {
        if (Interruptible::stopped()) return false;
        if (over()) return true;
        left = take_turn(i) || left;
        progress.tell(how_far());
        checkpoint.keep([this] { return state(); });
      }
    }
    return true;
  }

  const CountedRun& counted() const { return run_; }
  double time() const { return TimeLimit::seconds_of_machine() - began_; }
  std::uint64_t asked() const {
    std::uint64_t sum = 0;
    for (const Counts& counts : run_.operations) sum += counts.cases();
    return sum;
  }
  std::uint64_t asked_now() const { return asked() - before_; }

 private:
  std::string how_far() const {
    const double all = static_cast<double>(share_.size()) * static_cast<double>(operations_.size());
    const double rate = static_cast<double>(asked_now()) / time(), left = all - static_cast<double>(asked());
    return seconds_ > 0 ? in_words({(spent_ + time()) / seconds_, asked(), "case", rate, seconds_ - spent_ - time()})
                        : in_words({1 - left / all, asked(), "case", rate, left / rate});
  }
  bool over() const { return seconds_ > 0 && spent_ + time() >= seconds_; }

  /// Returns whether the operation has anything left to ask.
  bool take_turn(std::size_t i) {
    Counts& counts = run_.operations[i];
    const std::uint64_t next = counts.counted.empty() ? share_.first : counts.counted.back().last;
    const Soaked soaked(*operations_[i], run_.seed);
    std::vector<Counts> pieces(static_cast<std::size_t>(jobs_));
    const std::uint64_t reached = rounds_[i].run(
        next, share_.last, [&](std::size_t job, const Share& piece) { pieces[job] = soaked.count(piece); });
    for (const Counts& piece : pieces) counts.add(piece);
    return reached < share_.last;
  }

  double seconds_, spent_ = 0, began_ = TimeLimit::seconds_of_machine();
  std::uint64_t before_ = 0;  ///< asked by the interrupted run
  int jobs_ = 1;
  Share share_;
  std::vector<const Operation*> operations_;
  std::vector<Rounds> rounds_;
  CountedRun run_;
};

}  // namespace

int soak_command(const SoakCommand& asked, std::ostream& out, std::ostream& err) {
  SoakCommand command = asked;
  if (command.seconds == 0 && command.cases == 0) command.seconds = usual_soak;
  if (command.cases == 0) command.cases = most_cases;
  require_writable("--json", command.json_file);
  const Shard shard = shard_of(command.shard);
  tell(shard, err);
  Soak soak(command, shard);
  Checkpoint checkpoint(command.json_file,
                        {{"soak", command.operations},
                         {"seed", command.seed},
                         {"cases", command.cases},
                         {"seconds", command.seconds},
                         {"shard", shard.text()}},
                        err);
  if (!checkpoint.found().is_null()) soak.go_on_from(checkpoint.found());
  Progress progress(err, is_terminal(Stream::error), {}, 0);
  const Interruptible until_counted;
  const bool finished = soak.run(checkpoint, progress);
  progress.end();
  std::ostream& readable = is_standard_output(command.json_file) ? err : out;
  readable << table_of(soak.counted());
  err << fmt::format("touchstone: {} in {:.0f} s, {} a second\n", counted(soak.asked_now(), "case"), soak.time(),
                     grouped(static_cast<std::uint64_t>(static_cast<double>(soak.asked_now()) / soak.time())));
  if (!finished) {
    checkpoint.keep_now(soak.state());
    err << "touchstone: interrupted" << (checkpoint.file().empty() ? "" : "; the same command resumes from ")
        << checkpoint.file() << '\n';
    return interrupted;
  }
  write_file("--json", command.json_file, one_line(json_of(soak.counted())) + "\n");
  checkpoint.remove();
  return soak.counted().wrong() > 0 ? findings : nothing_found;
}

}  // namespace touchstone::program
