// SPDX-License-Identifier: Apache-2.0
#include "audit/judging/judge_logs.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "audit/engines/protocol.h"
#include "audit/judging/call_judge.h"
#include "audit/parallel.h"

namespace touchstone::audit {
namespace {

/// The number of calls that a job takes at a time.
constexpr std::size_t calls_at_once = 256;

/// The log's declaration of the recorded functions, with the caller's corrections.
Declaration declared(const JudgeOptions& options, const LogHeader& header) {
  Declaration declaration = header.declaration;
  if (options.boundary) declaration.boundary = *options.boundary;
  if (options.tolerance) declaration.tolerance = *options.tolerance;
  return declaration;
}

void require_one_engine(const Declaration& first, const Declaration& other, const std::string& file) {
  const auto require_same = [&](const std::string& field, const std::string& before, const std::string& got) {
    if (before != got) throw InvalidInput(file, field + ": expected " + before + ", as the logs before it, got " + got);
  };
  const auto named = [](const Declaration& one) { return one.engine.empty() ? "no name" : one.engine; };
  require_same("engine", named(first), named(other));
  require_same("boundary", boundary_word(first.boundary), boundary_word(other.boundary));
  require_same("tolerance", one_line(Json(first.tolerance)), one_line(Json(other.tolerance)));
}

/// One log, from which several jobs take calls.
class SharedLog {
 public:
  SharedLog(const JudgeOptions& options, const std::string& file, std::uint64_t before)
      : options_(options), file_(file), log_(file), read_(before) {}

  /// Reads this many calls from now on, before `take` pauses.
  void begin_piece(std::uint64_t calls) { until_ = read_ + calls; }
  bool ended() const { return ended_; }
  const LogReader& reader() const { return log_; }
  /// The declaration of the recorded functions; known from the first call on.
  Declaration declaration() const { return declaration_.value_or(declared(options_, log_.header())); }

  /// Fills objects whose memory is reused; returns their number.
  std::size_t take(std::vector<RecordedCall>& calls) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::size_t taken = 0;
    while (taken < calls.size() && !ended_ && read_ < until_) {
      RecordedCall& call = calls[taken];
      ended_ = !log_.next(call);
      if (ended_) break;
      if (!declaration_ || logs_ != log_.account().logs) begin_log();
      call.ordinal = read_++;
      const bool asked = std::find(options_.operations.begin(), options_.operations.end(), call.operation) !=
                         options_.operations.end();
      const bool judged_before = options_.counted && call.ordinal < options_.counted->read;
      taken += asked && !judged_before && call.ordinal % options_.shards == options_.shard - 1;
    }
    if (options_.progress) options_.progress(read_);
    return taken;
  }

  std::uint64_t read() const { return read_; }

 private:
  /// A file may hold several logs.
  void begin_log() {
    const Declaration declaration = declared(options_, log_.header());
    if (declaration_) require_one_engine(*declaration_, declaration, file_);
    declaration_ = declaration;
    logs_ = log_.account().logs;
  }

  const JudgeOptions& options_;
  const std::string file_;
  LogReader log_;
  std::optional<Declaration> declaration_;
  std::uint64_t read_, until_ = 0, logs_ = 0;
  std::mutex mutex_;
  bool ended_ = false;
};

}  // namespace

void SumOfCalls::add(CallJudge& judge, const std::vector<std::string>& sites) {
  in_float_ += judge.in_float(), in_double_ += judge.in_double();
  for (auto& [key, counted] : judge.take()) {
    const std::string& site = sites[key.second];
    CallJudge::Counted& cell = counted_[key.first][site.empty() ? "no place" : site];
    cell.answers.merge(counted.answers);
    cell.robust.merge(counted.robust);
  }
}

void SumOfCalls::go_on_from(const Tally& tally) {
  ++(tally.declaration.binary32 ? in_float_ : in_double_);
  for (const bool of_robust : {false, true}) {
    for (const OperationTally& operation : of_robust ? tally.robust : tally.operations) {
      for (const auto& [site, cell] : operation.families) {
        CallJudge::Counted& counted = counted_[find_operation(operation.operation)][site];
        (of_robust ? counted.robust : counted.answers) = cell;
      }
    }
  }
}

void SumOfCalls::complete(Tally& tally) {
  tally.repeat.recorded = true;
  tally.declaration.binary32 = in_float_ > 0 && in_double_ == 0;
  if (tally.declaration.engine.empty()) tally.declaration.engine = "recorded calls";
  for (const Operation* operation : all_operations()) {
    const auto found = counted_.find(operation);
    if (found == counted_.end()) continue;
    OperationTally answers{operation->name(), {}}, robust{operation->name(), {}};
    for (auto& [site, cell] : found->second) {
      answers.families.emplace_back(site, std::move(cell.answers));
      robust.families.emplace_back(site, std::move(cell.robust));
    }
    tally.operations.push_back(std::move(answers));
    tally.robust.push_back(std::move(robust));
  }
  counted_.clear();
}

JudgedLogs judge_logs(const JudgeOptions& options, const std::atomic<bool>& stop) {
  JudgedLogs result;
  Tally& tally = result.tally;
  tally.limits = options.limits;
  tally.grid.shards = options.shards;
  if (options.shards > 1) tally.grid.done = {options.shard};
  SumOfCalls sum;
  if (options.counted) sum.go_on_from(options.counted->tally);
  std::uint64_t read = 0;
  for (const std::string& file : options.files) {
    SharedLog log(options, file, read);
    // A header precedes the first call.
    log.begin_piece(options.calls_of_a_piece);
    std::vector<RecordedCall> first(calls_at_once);
    std::size_t begun = log.take(first);
    const Declaration declaration = log.declaration();
    if (tally.logs.empty()) tally.declaration = declaration;
    require_one_engine(tally.declaration, declaration, file);
    tally.logs.push_back(file);
    const int jobs = std::max(1, options.jobs);
    std::vector<CallJudge> judges(static_cast<std::size_t>(jobs), CallJudge(declaration, options.limits));
    while (true) {
      in_parallel(jobs, judges.size(), [&](std::size_t job) {
        std::vector<RecordedCall> calls(calls_at_once);
        if (job == 0) calls.swap(first);
        for (std::size_t taken = job == 0 ? begun : log.take(calls); taken > 0 && !stop; taken = log.take(calls))
          for (std::size_t i = 0; i < taken; ++i) judges[job].judge(calls[i]);
      });
      for (CallJudge& judge : judges) sum.add(judge, log.reader().sites());
      if (log.ended() || stop) break;
      const bool counted_before = options.counted && log.read() < options.counted->read;
      if (options.after_piece && !counted_before) {
        JudgedSoFar so_far{tally, log.read()};
        SumOfCalls(sum).complete(so_far.tally);
        options.after_piece(so_far);
      }
      log.begin_piece(options.calls_of_a_piece);
      first.assign(calls_at_once, {});
      begun = log.take(first);
    }
    read = log.read();
    result.accounts.push_back(log.reader().account());
    if (stop) break;
  }
  sum.complete(tally);
  tally.interrupted = stop;
  return result;
}

}  // namespace touchstone::audit
