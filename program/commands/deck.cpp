// SPDX-License-Identifier: Apache-2.0
#include <atomic>

#include "audit/counting/audit_run.h"
#include "audit/parallel.h"
#include "program/commands/commands.h"
#include "report/pages/deck_page.h"
#include "report/pages/simulation_page.h"
#include "simulate/gas/referee.h"
#include "simulate/scene_reading.h"

namespace touchstone::program {
namespace {

/// All steps of the scene in float, in double and by robust.
report::PlayedScene played(const std::string& file) {
  try {
    const auto scene = simulate::read_scene(parse_line(text_of_file(file, "--scenes")));
    simulate::Simulation simulation(scene, {std::begin(simulate::all_runs), std::end(simulate::all_runs)});
    simulate::Recording recording(simulation);
    recording.add(simulation);
    while (simulation.step() < scene.settings.steps) simulation.advance(), recording.add(simulation);
    return {scene.title, scene.about, report::player_data(recording)};
  } catch (const InvalidInput& refused) {
    throw UsageError(file + ": " + refused.what());
  }
}

}  // namespace

int deck_command(const DeckCommand& command, std::ostream& err) {
  require_writable("--page", command.page);
  AuditOptions options;
  std::map<std::string, report::PlayedScene> scenes;
  for (const report::DeckSection& section : report::deck_sections()) {
    for (const std::string& operation : section.operations) options.operations.push_back(find_operation(operation));
    if (!command.scenes.empty() && !section.scene.empty())
      scenes.emplace(section.scene, played(command.scenes + "/" + section.scene + ".json"));
  }
  options.cases = command.cases;
  options.jobs = command.jobs > 0 ? command.jobs : jobs_of_machine();
  const std::atomic<bool> stop{false};
  const Tally tally = run_audit(options, stop, [](const std::string&, std::uint64_t) {});
  write_file("--page", command.page, report::deck_page(tally, scenes));
  if (!is_standard_output(command.page)) err << command.page << '\n';
  return nothing_found;
}

}  // namespace touchstone::program
