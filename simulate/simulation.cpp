// SPDX-License-Identifier: Apache-2.0
#include "simulate/simulation.h"

namespace touchstone::simulate {

bool same_contacts(const Snapshot& a, const Snapshot& b) {
  if (a.impacts.size() != b.impacts.size()) return false;
  for (std::size_t i = 0; i < a.impacts.size(); ++i)
    if (!(a.impacts[i].touch == b.impacts[i].touch)) return false;
  return true;
}

Simulation::Simulation(const Scene& scene, const std::vector<std::string>& runs)
    : scene_(scene), parted_(runs.size(), std::vector<bool>(runs.size())) {
  for (const std::string& name : runs) runs_.push_back(run_of(name, scene));
}

void Simulation::advance() {
  std::vector<State<double>> before;
  for (const auto& run : runs_) before.push_back(run->now().state);
  try {
    for (const auto& run : runs_) run->advance();
  } catch (const StepError& wrong) {
    throw StepError("step " + std::to_string(step_ + 1) + ", " + wrong.what());
  }
  ++step_;
  look_for_partings(before);
}

void Simulation::look_for_partings(const std::vector<State<double>>& before) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    for (std::size_t j = i + 1; j < runs_.size(); ++j) {
      if (parted_[i][j] || same_contacts(runs_[i]->now(), runs_[j]->now())) continue;
      parted_[i][j] = true;
      if (auto found = parting(step_, *runs_[i], before[i], *runs_[j], before[j])) partings_.push_back(*found);
    }
  }
}

void Simulation::restore(std::uint64_t step, const std::vector<Snapshot>& then, const std::vector<Drift>& drifts,
                         const std::vector<std::pair<std::size_t, std::size_t>>& parted) {
  step_ = step;
  for (std::size_t i = 0; i < runs_.size(); ++i) runs_[i]->restore(then[i], drifts[i]);
  for (const auto& [i, j] : parted) parted_[i][j] = true;
}

}  // namespace touchstone::simulate
