// SPDX-License-Identifier: Apache-2.0
#include "simulate/recording.h"

#include "catalogue/numbers/ulps.h"

namespace touchstone::simulate {

using catalogue::nearest;

Recording::Recording(const Simulation& simulation) : scene_(simulation.scene()) {
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    runs_.emplace_back();
    runs_.back().name = simulation.run(i).name();
    runs_.back().engine = simulation.run(i).engine() != nullptr;
  }
}

void Recording::add(OfRun& run, const Snapshot& now, const Drift& drift) {
  run.states.push_back(now.state);
  run.impacts.push_back(now.impacts);
  run.energy.push_back(nearest(now.energy));
  run.law.push_back(nearest(drift.law));
  run.scheme.push_back(nearest(drift.scheme));
  run.decision.push_back(nearest(drift.decision));
  run.rounding.push_back(nearest(run.engine ? drift.own : drift.rounding));
  run.momentum.push_back({nearest(now.momentum[0]), nearest(now.momentum[1]), nearest(now.momentum[2])});
}

void Recording::add(const Simulation& simulation) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    runs_[i].ended = simulation.run(i).ended();
    if (runs_[i].ended.empty()) add(runs_[i], simulation.run(i).now(), simulation.run(i).drift());
  }
  for (const Parting& parting : simulation.partings())
    if (parting.step == simulation.step()) partings_.emplace_back(parting.step, in_json(scene_, parting));
}

void Recording::add(const Frame& frame) {
  for (std::size_t i = 0; i < runs_.size(); ++i) add(runs_[i], frame.runs[i], frame.drifts[i]);
  for (const Json& parting : frame.partings) partings_.emplace_back(frame.step, parting);
}

}  // namespace touchstone::simulate
