// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "audit/platform.h"
#include "catalogue/codec/document.h"
#include "program/commands/commands.h"
#include "program/terminal/engine_lines.h"
#include "program/terminal/exit_codes.h"
#include "program/terminal/names.h"
#include "report/pages/simulation_page.h"
#include "simulate/gas/referee.h"
#include "simulate/scene_reading.h"
#include "simulate/summary.h"
#include "simulate/trajectory.h"

namespace touchstone::program {
namespace {

using simulate::Frame;
using simulate::Simulation;

template <class Read>
auto read_or_refuse(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const InvalidInput& refused) {
    throw UsageError(file + ": " + refused.what());
  }
}

int gas_command(const SimulateCommand& command, const Json& json, std::ostream& out, std::ostream& err) {
  if (!command.trajectory.empty() || command.resume || !command.page.empty() || command.steps)
    throw UsageError(command.file + ": an exact gas has no steps: no --steps, --trajectory, --resume, --page");
  const auto scene = read_or_refuse(command.file, [&] { return simulate::gas::read_gas(json); });
  try {
    int code = simulate::gas::run_gas(scene, out) ? nothing_found : findings;
    for (const std::string& engine : command.engines) {
      const auto verdict = simulate::gas::referee(scene, engine_lines(engine, command.timeout), engine);
      out << simulate::gas::sentence_of(scene, verdict) << std::endl;
      if (verdict.ended.empty() || verdict.unsupported) continue;
      err << "touchstone: engine " << verdict.engine << ": " << verdict.ended << '\n';
      if (code == nothing_found) code = engine_failed;
    }
    return code;
  } catch (const simulate::gas::GasError& wrong) {
    err << "touchstone: " << command.file << ": " << wrong.what() << '\n';
    return bad_usage;
  }
}

std::vector<std::string> runs_named(const std::string& names) {
  std::vector<std::string> runs;
  for (const std::string& name : split(names)) {
    if (std::find(runs.begin(), runs.end(), name) != runs.end()) continue;
    if (std::find(std::begin(simulate::all_runs), std::end(simulate::all_runs), name) == std::end(simulate::all_runs))
      throw UsageError("--runs: no run " + name + "; expected float, double, robust");
    runs.push_back(name);
  }
  if (runs.empty()) throw UsageError("--runs: at least one of float, double, robust");
  return runs;
}

/// Ensures that the outputs overwrite neither the scene nor each other.
void require_apart(const SimulateCommand& command) {
  const auto same = [](const std::string& one, const std::string& other) {
    std::error_code error;
    if (one.empty() ||
        !(std::filesystem::is_regular_file(path_of(one), error) || !std::filesystem::exists(path_of(one), error)))
      return false;
    return std::filesystem::weakly_canonical(path_of(one), error) ==
               std::filesystem::weakly_canonical(path_of(other), error) ||
           std::filesystem::equivalent(path_of(one), path_of(other), error);
  };
  if (same(command.file, command.trajectory)) throw UsageError("--trajectory: " + command.trajectory + " is the scene");
  if (same(command.file, command.page)) throw UsageError("--page: " + command.page + " is the scene");
  if (same(command.page, command.trajectory)) throw UsageError("--page: " + command.page + " is the trajectory, too");
}

/// A trajectory's file, written as the steps are made.
class Trajectory {
 public:
  explicit Trajectory(const std::string& file) : file_(file), csv_(file.size() > 4 && file.ends_with(".csv")) {}

  /// Reads the file's content, sets the simulation to its last step, and truncates an incomplete last line.
  void resume(Simulation& simulation, const std::function<void(const Frame&)>& visit) {
    if (csv_ || file_.empty() || is_standard_output(file_))
      throw UsageError("--resume: needs --trajectory with a file of JSON lines");
    if (!std::filesystem::exists(path_of(file_))) return;
    if (!std::filesystem::is_regular_file(path_of(file_)))
      throw UsageError("--resume: " + file_ + " is no regular file");
    std::uint64_t length = 0;
    try {
      std::ifstream in = opened_to_read(file_, "--trajectory");
      length = read_trajectory(in, simulation, [&](const Frame& frame) { ++resumed_, visit(frame); });
    } catch (const InvalidInput& refused) {
      throw UsageError(file_ + ": " + refused.what());
    }
    std::filesystem::resize_file(path_of(file_), length);
    started_ = length > 0;
  }
  bool resumed() const { return resumed_ > 0; }

  void begin(const Simulation& simulation) {
    if (file_.empty()) return;
    if (!is_standard_output(file_)) {
      opened_.open(file_, started_ ? std::ios::app : std::ios::trunc);
      if (!opened_) throw UsageError("--trajectory: " + file_ + ": cannot be written");
    }
    if (!started_) csv_ ? simulate::write_csv_header(out()) : write_header(simulation, out());
    if (!resumed()) write(simulation);
  }
  void write(const Simulation& simulation) {
    if (file_.empty()) return;
    csv_ ? write_csv_step(simulation, out()) : write_step(simulation, out());
    if (!out().flush()) throw UsageError("--trajectory: " + file_ + ": cannot be written");
  }

 private:
  std::ostream& out() { return is_standard_output(file_) ? std::cout : opened_; }

  std::string file_;
  bool csv_, started_ = false;
  std::uint64_t resumed_ = 0;
  std::ofstream opened_;
};

}  // namespace

int simulate_command(const SimulateCommand& command, std::ostream& out, std::ostream& err) {
  const Json json = read_or_refuse(command.file, [&] { return parse_document(text_of_file(command.file)); });
  if (simulate::gas::is_gas(json)) return gas_command(command, json, out, err);
  const auto scene = read_or_refuse(command.file, [&] { return simulate::read_scene(json); });
  require_apart(command);
  Simulation simulation(scene, runs_named(command.runs));
  if (command.resume && !command.engines.empty()) throw UsageError("--resume: an engine cannot resume from a file");
  for (const std::string& engine : command.engines)
    simulation.add(engine_run(engine_lines(engine, command.timeout), engine, scene, simulation.names()));
  Trajectory trajectory(command.trajectory);
  simulate::Recording recording(simulation);
  const bool shown = !command.page.empty();
  require_writable("--page", command.page);
  if (command.resume)
    trajectory.resume(simulation, [&](const Frame& frame) {
      if (shown) recording.add(frame);
    });
  if (shown && !trajectory.resumed()) recording.add(simulation);
  trajectory.begin(simulation);
  simulate::Summary summary(simulation);
  const std::uint64_t steps = command.steps.value_or(scene.settings.steps);
  int code = nothing_found;
  try {
    while (simulation.step() < steps) {
      simulation.advance();
      trajectory.write(simulation);
      summary.count();
      if (shown) recording.add(simulation);
    }
  } catch (const simulate::StepError& wrong) {
    err << "touchstone: " << command.file << ": " << wrong.what() << '\n';
    code = bad_usage;
  }
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const simulate::EngineRun* const engine = simulation.run(i).engine();
    if (engine == nullptr || engine->ended().empty() || engine->unsupported()) continue;
    err << "touchstone: engine " << engine->name() << ": " << engine->ended() << '\n';
    if (code == nothing_found) code = engine_failed;
  }
  if (shown) write_file("--page", command.page, report::simulation_page(recording));
  summary.print(is_standard_output(command.trajectory) ? err : out);
  return code;
}

}  // namespace touchstone::program
