// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <mutex>
#include <thread>

#include "audit/cli/commands.h"
#include "audit/cli/program.h"
#include "audit/judge/audit_run.h"
#include "audit/report/html.h"
#include "audit/report/table.h"
#include "audit/report/tally_json.h"

namespace touchstone::audit {
namespace {

std::atomic<bool> interrupted{false};
extern "C" void on_interrupt(int) { interrupted = true; }

/// One line on a terminal, rewritten at most ten times a second; nothing elsewhere.
class Progress {
 public:
  explicit Progress(std::ostream& err) : err_(err), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (shown_) err_ << "\r\x1b[K" << std::flush;
  }
  void operator()(const std::string& operation, std::uint64_t done, std::uint64_t of) {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    err_ << "\r\x1b[K" << operation << ": " << 100 * done / of << " %" << std::flush;
  }

 private:
  std::ostream& err_;
  bool shown_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point last_{};
};

void require_known_families(const AuditOptions& options) {
  for (const std::string& family : options.families) {
    bool known = false;
    for (const Operation* operation : options.operations) {
      for (const std::string& name : operation->families()) known = known || name == family;
    }
    if (!known) throw UsageError("--families " + family + ": a family of one of the operations (see touchstone ops --json)");
  }
}

void write_file(const std::string& file, const std::string& text) {
  std::ofstream opened(file);
  if (!(opened << text << std::flush)) throw UsageError("--json " + file + ": a file that can be written");
}

}  // namespace

int audit_command(const AuditCommand& command, std::ostream& out, std::ostream& err) {
  AuditOptions options;
  options.operations = operations_named(command.operations);
  options.families = split(command.families);
  options.cases = command.cases;
  options.seed = command.seed;
  options.seconds = command.seconds;
  options.jobs = command.jobs > 0 ? command.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  require_known_families(options);
  if (!command.engine.empty()) {
    options.engine = [&command] { return pipe_engine(command.engine, command.timeout, &interrupted); };
  }
  const auto previous = std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  Tally tally;
  {
    Progress progress(err);
    tally = run_audit(options, interrupted, [&](const std::string& name, std::uint64_t done) { progress(name, done, command.cases); });
  }
  std::signal(SIGINT, previous);
  out << text_table(tally) << std::flush;
  if (!command.json_file.empty()) write_file(command.json_file, tally_json(tally));
  if (!command.report_directory.empty()) {
    const std::unique_ptr<Engine> for_maps = options.engine ? options.engine() : nullptr;
    write_report(tally, command.report_directory, for_maps.get());
    out << "report: " << command.report_directory << "/index.html\n";
  }
  return tally.has_findings() ? findings : nothing_found;
}

}  // namespace touchstone::audit
