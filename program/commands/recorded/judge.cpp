// SPDX-License-Identifier: Apache-2.0
#include "program/commands/recorded/judge.h"

#include "audit/counting/tally_json.h"
#include "audit/judging/judge_logs.h"
#include "audit/parallel.h"
#include "audit/place.h"
#include "audit/platform.h"
#include "program/commands/commands.h"
#include "program/commands/recorded/judge_files.h"
#include "program/commands/recorded/log.h"
#include "program/runs/checkpoint.h"
#include "program/runs/shard.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/interruptible.h"
#include "program/terminal/progress.h"
#include "report/pages/html.h"
#include "report/screen/recorded.h"
#include "report/screen/table.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

JudgeOptions judge_options(const JudgeCommand& command, const Shard& shard) {
  JudgeOptions options;
  options.files = command.files;
  options.operations = operations_named(command.operations);
  if (command.boundary == "closed") options.boundary = Declaration::Boundary::closed;
  if (command.boundary == "open") options.boundary = Declaration::Boundary::open;
  if (command.boundary == "unspecified") options.boundary = Declaration::Boundary::unspecified;
  options.tolerance = command.tolerance;
  options.jobs = command.jobs > 0 ? command.jobs : jobs_of_machine();
  options.shard = shard.index, options.shards = shard.of;
  return options;
}

/// The parameters that identify this run.
Json run_of(const JudgeCommand& command, const Shard& shard) {
  return {{"judge", command.files},
          {"ops", command.operations},
          {"boundary", command.boundary},
          {"pairs", command.pairs},
          {"columns", command.columns},
          {"engine", command.engine},
          {"tolerance", written(command.tolerance.value_or(0))},
          {"shard", shard.text()}};
}

/// Returns whether anything was judged; otherwise prints the reason.
bool judged_any(const JudgedLogs& judged, std::ostream& err) {
  if (sum_of(judged.tally.operations).cases() > 0) return true;
  std::uint64_t calls = 0;
  for (const LogAccount& account : judged.accounts) calls += account.calls;
  err << "touchstone: nothing was judged: "
      << (judged.accounts.empty() ? "the engine answered none of the questions\n"
          : calls == 0            ? "the log holds no call\n"
                                  : "no recorded call of this shard is within the contract of these operations\n");
  return false;
}

}  // namespace

int judge_command(const JudgeCommand& command, std::ostream& out, std::ostream& err) {
  require_writable("--json", command.json_file);
  const Gate gate = gate_of(command.gate);
  const bool asks_engine = !command.pairs.empty() || !command.columns.empty();
  if (!command.engine.empty() && !asks_engine)
    throw UsageError("--engine: expected --pairs or --columns too, whose questions it answers");
  const Shard shard = shard_of(command.shard);
  if (shard.of > 1 && asks_engine) throw UsageError("--shard: expected recorded calls, not --pairs or --columns");
  tell(shard, err);
  JudgeOptions options = judge_options(command, shard);
  Progress progress(err, is_terminal(Stream::error), {}, 0);
  options.progress = [&](std::uint64_t read) { progress.tell(audit::counted(read, "call") + " read"); };
  const std::atomic<bool>& stopped = Interruptible::stopped();
  JudgedLogs judged;
  EngineNotes notes;
  Checkpoint checkpoint(shard.named() ? command.json_file : "", run_of(command, shard), err);
  if (!checkpoint.found().is_null()) {
    const Place found{checkpoint.found(), ""};
    options.counted = audit::JudgedSoFar{audit::read_tally(found.at("tally").text()), found.at("read").count()};
  }
  options.after_piece = [&](const audit::JudgedSoFar& so_far) {
    checkpoint.keep([&] { return Json{{"tally", tally_json(so_far.tally)}, {"read", so_far.read}}; });
  };
  {
    const Interruptible until_judged;
    judged = asks_engine ? judge_files(command, notes) : judge_logs(options, stopped);
  }
  progress.end();
  notes.tell(err);
  for (std::size_t i = 0; i < judged.accounts.size(); ++i) print_account(judged.accounts[i], err);
  Tally& tally = judged.tally;
  if (!tally.interrupted && !judged_any(judged, err)) return bad_usage;
  tally.max_surplus = command.gate.max_surplus;
  if (tally.repeat.options.empty()) tally.repeat.program = command.program;
  std::ostream& readable = is_standard_output(command.json_file) ? err : out;
  readable << text_table(tally, command.summary ? Detail::operations : Detail::all) << recorded_table(tally)
           << std::flush;
  const GateResult result = finish_gate(command.gate, gate, tally, readable);
  if (tally.interrupted && shard.named()) {
    err << "touchstone: interrupted, nothing is written"
        << (checkpoint.file().empty() ? "" : "; the same command resumes from ") << checkpoint.file() << '\n';
    return interrupted;
  }
  write_file("--json", command.json_file, tally_json(tally));
  checkpoint.remove();
  if (!command.report_directory.empty()) {
    try {
      write_report(tally, command.report_directory, options.jobs, nullptr,
                   {.gate = command.gate.decides() ? gate_in_words(tally, result) : ""});
    } catch (const std::runtime_error& failed) {
      throw UsageError(std::string("--report ") + failed.what());
    }
    readable << "report: " << command.report_directory << "/index.html\n";
  }
  if (tally.interrupted) {
    err << "touchstone: interrupted; the results so far were written\n";
    return interrupted;
  }
  return (command.gate.decides() ? !result.passed() : tally.has_findings()) ? findings : nothing_found;
}

}  // namespace touchstone::program
