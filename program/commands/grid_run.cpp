// SPDX-License-Identifier: Apache-2.0
#include "program/commands/grid_run.h"

#include <fmt/format.h>

#include "audit/parallel.h"
#include "audit/place.h"
#include "audit/platform.h"
#include "audit/time_limit.h"
#include "program/runs/rounds.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/interruptible.h"

namespace touchstone::program {
namespace {

/// The interval at which progress is checked.
constexpr double seconds_of_a_round = 0.5;

std::uint64_t configurations(const Operation& operation, const ExhaustCommand& command) {
  const auto total = operation.configurations(command.grid, command.list_length);
  if (!total) throw UsageError("--grid: expected fewer than 2^64 configurations, got more");
  return *total;
}

/// The questions go to one engine in turn, as it was started.
int jobs_of(const ExhaustCommand& command) {
  if (command.jobs > 0) return command.jobs;
  return command.engine.empty() ? jobs_of_machine() : 1;
}

Json named(const ExhaustCommand& command, const Shard& shard) {
  return {{"exhaust", command.operation},   {"grid", command.grid},     {"list_length", command.list_length},
          {"decisions", command.decisions}, {"engine", command.engine}, {"shard", shard.text()}};
}

}  // namespace

GridRun::GridRun(const Operation& operation, const ExhaustCommand& command, const Shard& shard, std::ostream& err)
    : total_(configurations(operation, command)),
      share_(share_of(total_, shard)),
      next_(share_.first),
      began_at_(share_.first),
      jobs_(jobs_of(command)),
      err_(err),
      checkpoint_(shard.named() ? command.json_file : "", named(command, shard), err),
      progress_(err, is_terminal(Stream::error), {}, 0) {
  if (checkpoint_.found().is_null()) return;
  next_ = began_at_ = Place{checkpoint_.found(), "state"}.at("next").count();
  if (next_ < share_.first || next_ > share_.last)
    throw UsageError(checkpoint_.file() + ": state.next: expected an index of the shard");
}

Json GridRun::counted() const {
  const Json& state = checkpoint_.found();
  return state.is_null() ? state : Place{state, "state"}.at("counted").value;
}

bool GridRun::run(const std::function<void(std::size_t, Share)>& work, const std::function<Json()>& state) {
  const Interruptible until_done;
  Rounds rounds(jobs_, seconds_of_a_round);
  const double began = TimeLimit::seconds_of_machine();
  const auto kept = [&] { return Json{{"next", next_}, {"counted", state()}}; };
  while (next_ < share_.last && !Interruptible::stopped()) {
    next_ = rounds.run(next_, share_.last, work);
    tell(TimeLimit::seconds_of_machine() - began);
    checkpoint_.keep(kept);
  }
  progress_.end();
  if (next_ == share_.last) return true;
  checkpoint_.keep_now(kept());
  err_ << "touchstone: interrupted, nothing is written"
       << (checkpoint_.file().empty() ? "" : "; the same command resumes from ") << checkpoint_.file() << '\n';
  return false;
}

void GridRun::tell(double seconds) {
  const auto done = static_cast<double>(next_ - share_.first), left = static_cast<double>(share_.last - next_);
  const double rate = static_cast<double>(next_ - began_at_) / seconds;
  progress_.tell(in_words({done / (done + left), next_ - share_.first, "configuration", rate, left / rate}));
}

}  // namespace touchstone::program
