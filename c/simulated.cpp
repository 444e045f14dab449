// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "c/made.h"
#include "c/options.h"
#include "c/touchstone.h"
#include "catalogue/codec/document.h"
#include "report/pages/simulation_page.h"
#include "simulate/gas/gas_scene.h"
#include "simulate/scene_reading.h"
#include "simulate/summary.h"

namespace touchstone::c {
namespace {

Json simulated_gas(const Json& scene) {
  std::ostringstream summary;
  const auto gas = simulate::gas::read_gas(scene);
  Json line = Json::object();
  try {
    simulate::gas::run_gas(gas, summary);
  } catch (const simulate::gas::GasError& wrong) {
    line["ended"] = wrong.what();
  }
  line["summary"] = summary.str();
  return line;
}

Json simulated(const Json& json, Options options) {
  std::vector<std::string> runs;
  std::uint64_t steps = 0;
  options.read("runs", runs);
  options.read("steps", steps);
  options.require_known();
  if (simulate::gas::is_gas(json)) return simulated_gas(json);
  const simulate::Scene scene = simulate::read_scene(json);
  if (runs.empty()) runs.assign(std::begin(simulate::all_runs), std::end(simulate::all_runs));
  for (const std::string& run : runs) {
    if (std::count(std::begin(simulate::all_runs), std::end(simulate::all_runs), run) == 0)
      throw InvalidInput("options.runs", "no run " + run + "; expected float, double, robust");
    if (std::count(runs.begin(), runs.end(), run) > 1) throw InvalidInput("options.runs", run + " is named twice");
  }
  simulate::Simulation simulation(scene, runs);
  simulate::Recording recording(simulation);
  simulate::Summary summary(simulation);
  recording.add(simulation);
  Json line = Json::object();
  try {
    while (simulation.step() < (steps == 0 ? scene.settings.steps : steps)) {
      simulation.advance();
      summary.count();
      recording.add(simulation);
    }
  } catch (const simulate::StepError& wrong) {
    line["ended"] = wrong.what();
  }
  std::ostringstream text;
  summary.print(text);
  line["summary"] = text.str();
  line["page"] = report::simulation_page(recording);
  return line;
}

}  // namespace
}  // namespace touchstone::c

int touchstone_simulate(const char* scene, const char* options, char** result, touchstone_error* error) {
  using namespace touchstone;
  return c::made(result, error, [&] {
    const catalogue::Json json = catalogue::parse_document(c::text_of(scene, "scene"));
    return catalogue::one_line(c::simulated(json, c::Options(options)));
  });
}
