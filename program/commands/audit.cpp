// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "audit/engines/notes.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/nearest_double.h"
#include "program/commands/commands.h"
#include "program/runs/checkpoint.h"
#include "program/runs/shard.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/interruptible.h"
#include "program/terminal/names.h"
#include "program/terminal/progress.h"
#include "report/pages/html.h"
#include "report/screen/screen.h"
#include "report/screen/table.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

void require_known_families(const AuditOptions& options) {
  for (const std::string& family : options.families) {
    bool known = false;
    std::vector<std::string> names;
    for (const Operation* operation : options.operations) {
      for (const std::string& name : operation->families()) known = known || name == family, names.push_back(name);
    }
    if (!known)
      throw UsageError("--families " + family + ": no family of these operations" + did_you_mean(family, names) +
                       "; touchstone ops --json lists them");
  }
}

/// "LEAST,MOST", decimal or hexadecimal.
Limits limits_named(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto least = nearest_double(std::string_view(text).substr(0, comma), true),
             most = nearest_double(std::string_view(text).substr(std::min(comma + 1, text.size())), true);
  if (!least || !most || !(*least > 0) || !(*least <= *most) || std::isinf(*most))
    throw UsageError("--ordinary " + text + ": LEAST,MOST, two positive numbers, the first not above the second");
  return {*least, *most};
}

/// Creates the report's directory, and checks that it is writable, before the first question.
void require_directory(const std::string& directory, double seconds) {
  if (directory.empty() && seconds > 0)
    throw UsageError("--report-seconds: expected --report too, whose maps it limits");
  if (directory.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path_of(directory), error);
  if (error || !std::filesystem::is_directory(path_of(directory), error) || !can_write_into(directory)) {
    throw UsageError("--report " + directory + ": a directory that can be written");
  }
}

/// The tally of --before, read before the first question.
std::optional<Tally> earlier_audit(const AuditCommand& command) {
  if (command.before.empty()) return std::nullopt;
  if (command.report_directory.empty())
    throw UsageError("--before " + command.before + ": expected --report too, which shows the two side by side");
  const std::string text = text_of_file(command.before, "--before");
  try {
    return read_tally(text);
  } catch (const InvalidInput& refused) {
    throw UsageError("--before " + command.before + ": expected the file of an audit's --json; " + refused.what());
  }
}

/// The parameters that identify this audit.
Json named(const AuditCommand& command, const Shard& shard) {
  return {{"audit", command.operations}, {"engine", command.engine}, {"families", command.families},
          {"cases", command.cases},      {"seed", command.seed},     {"seconds", written(command.seconds)},
          {"by_cost", command.by_cost},  {"range", command.range},   {"ordinary", command.ordinary},
          {"shard", shard.text()}};
}

/// Attributes write errors to --report.
void reporting(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::runtime_error& failed) {
    throw UsageError(std::string("--report ") + failed.what());
  }
}

constexpr const char* how_to_see_more =
    "--verbose prints every family and finding with the line that repeats it; --json FILE and --report DIR keep them "
    "all\n";

int exit_code(const Tally& tally, bool failed, std::ostream& err) {
  if (tally.interrupted) {
    err << "touchstone: interrupted; the results so far were written\n";
    return interrupted;
  }
  if (failed) return findings;
  const Cell sum = sum_of(tally.operations);
  if (sum.answered() > 0) return nothing_found;
  err << "touchstone: nothing was judged: "
      << (sum.cases() > 0 ? "the engine says of every question that it is unsupported\n"
                          : "no question of these families is within the contract of these operations\n");
  return bad_usage;
}

}  // namespace

int audit_command(const AuditCommand& command, std::ostream& out, std::ostream& err) {
  AuditOptions options;
  options.operations = operations_named(command.operations);
  options.families = split(command.families);
  options.cases = command.cases;
  options.by_cost = command.by_cost;
  options.seed = command.seed;
  options.seconds = command.seconds;
  options.jobs = command.jobs > 0 ? command.jobs : jobs_of_machine();
  options.limits = limits_named(command.ordinary);
  options.ordinary_only = command.range == "ordinary";
  require_known_families(options);
  require_writable("--json", command.json_file);
  require_directory(command.report_directory, command.report_seconds);
  EngineNotes notes;
  Progress progress(err, is_terminal(Stream::error), options.operations, options.cases);
  if (options.by_cost) progress.ask_by_cost();
  const Gate gate = gate_of(command.gate);
  const Shard shard = shard_of(command.shard);
  tell(shard, err);
  options.shard = shard.index, options.shards = shard.of;
  const std::atomic<bool>& stopped = Interruptible::stopped();
  const std::optional<Tally> before = earlier_audit(command);
  if (!command.engine.empty()) {
    require_asked_of_engines(options.operations);
    options.engine = [&] {
      auto engine = pipe_engine(command.engine, command.timeout, &stopped, &notes);
      progress.leave_out(
          [&](const Operation& o) { return o.metadata().is_implementation() || !engine->supports(o.name()); });
      return engine;
    };
  }
  Checkpoint checkpoint(shard.named() ? command.json_file : "", named(command, shard), err);
  if (!checkpoint.found().is_null()) options.counted = read_tally(checkpoint.found().get<std::string>());
  const auto complete = [&](Tally& sum) {
    sum.max_surplus = command.gate.max_surplus;
    sum.repeat = repeat_of(command.program, command.engine, command.timeout);
  };
  options.smaller = [&](const Operation& of, std::size_t done, std::size_t all) {
    progress.smaller(of.name(), done, all);
  };
  options.after_operation = [&](const Tally& sum) {
    checkpoint.keep([&] { return Json(tally_json(sum)); });
    if (command.report_directory.empty()) return;
    Tally so_far = sum;
    complete(so_far);
    reporting([&] {
      write_so_far(so_far, command.report_directory,
                   {.before = before ? &*before : nullptr, .expected = progress.operations()});
    });
  };
  Tally tally;
  try {
    const Interruptible until_counted;
    tally = run_audit(options, stopped, [&](const std::string& name, std::uint64_t done) { progress(name, done); });
  } catch (const EngineError& failed) {
    if (!stopped) throw EngineError(failed.what() + notes.of_first_line());
    // Interrupted before the engine had written its first line.
    tally.interrupted = true;
    tally.declaration.engine = command.engine;
  }
  progress.end();
  notes.tell(err, command.verbose);
  complete(tally);
  std::ostream& readable = is_standard_output(command.json_file) ? err : out;
  const bool on_terminal = &readable == &std::cout && is_terminal(Stream::output);
  if (on_terminal && !command.summary && !command.verbose)
    readable << screen(tally, how_to_see_more, command.width) << std::flush;
  else readable << text_table(tally, command.summary ? Detail::operations : Detail::all) << std::flush;
  if (tally.interrupted && shard.named()) {
    err << "touchstone: interrupted, nothing is written"
        << (checkpoint.file().empty() ? "" : "; the same command resumes from ") << checkpoint.file() << '\n';
    return interrupted;
  }
  const GateResult result = finish_gate(command.gate, gate, tally, readable);
  write_file("--json", command.json_file, tally_json(tally));
  checkpoint.remove();
  if (!command.report_directory.empty()) {
    const std::unique_ptr<Engine> for_maps = options.engine && !stopped ? options.engine() : nullptr;
    reporting([&] {
      write_report(tally, command.report_directory, options.jobs, for_maps.get(),
                   {.before = before ? &*before : nullptr,
                    .gate = command.gate.decides() ? gate_in_words(tally, result) : "",
                    .progress = [&progress](const std::string& name, std::size_t done,
                                            std::size_t all) { progress.step("report", name, done, all); },
                    .seconds = command.report_seconds,
                    .pages_stand = checkpoint.found().is_null()});
    });
    progress.end();
    readable << "report: " << command.report_directory << "/index.html\n";
  }
  return exit_code(tally, command.gate.decides() ? !result.passed() : tally.has_findings(), err);
}

}  // namespace touchstone::program
