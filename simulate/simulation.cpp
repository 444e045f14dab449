// SPDX-License-Identifier: Apache-2.0
#include "simulate/simulation.h"

#include <algorithm>

namespace touchstone::simulate {

bool same_contacts(const Snapshot& a, const Snapshot& b) {
  if (a.impacts.size() != b.impacts.size()) return false;
  for (std::size_t i = 0; i < a.impacts.size(); ++i)
    if (!(a.impacts[i].touch == b.impacts[i].touch)) return false;
  return true;
}

bool same_set_of_contacts(const Snapshot& a, const Snapshot& b) {
  const auto all_in = [](const Snapshot& one, const Snapshot& other) {
    return std::all_of(one.impacts.begin(), one.impacts.end(), [&](const Impact& impact) {
      return std::any_of(other.impacts.begin(), other.impacts.end(),
                         [&](const Impact& found) { return found.touch == impact.touch; });
    });
  };
  return all_in(a, b) && all_in(b, a);
}

Simulation::Simulation(const Scene& scene, const std::vector<std::string>& runs)
    : scene_(scene), parted_(runs.size(), std::vector<bool>(runs.size())) {
  for (const std::string& name : runs)
    runs_.push_back(run_of(name, scene, runs_.empty() ? nullptr : runs_.back().get()));
  departures_.resize(runs_.size());
}

void Simulation::add(std::unique_ptr<EngineRun> run) {
  runs_.push_back(std::move(run));
  for (auto& row : parted_) row.push_back(true);
  parted_.emplace_back(runs_.size(), true);  // partings concern questions, which an engine is not asked
  departures_.emplace_back();
}

std::vector<std::string> Simulation::names() const {
  std::vector<std::string> names;
  for (const auto& run : runs_) names.push_back(run->name());
  return names;
}

bool Simulation::none_parted() const {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    for (std::size_t j = i + 1; j < runs_.size(); ++j) {
      if (runs_[i]->engine() != nullptr || runs_[j]->engine() != nullptr) continue;
      if (parted_[i][j]) return false;
      ++pairs;
    }
  }
  return pairs > 0;
}

void Simulation::advance() {
  std::vector<State<double>> before;
  for (const auto& run : runs_) before.push_back(run->now().state);
  try {
    for (const auto& run : runs_)
      if (run->engine() == nullptr) run->advance();
  } catch (const StepError& wrong) {
    throw StepError("step " + std::to_string(step_ + 1) + ", " + wrong.what());
  }
  ++step_;
  for (const auto& run : runs_) {
    if (run->engine() == nullptr || !run->ended().empty()) continue;
    try {
      run->advance();
    } catch (const StepError& wrong) {
      run->end("step " + std::to_string(step_) + ": " + wrong.what());
    }
  }
  look_for_partings(before);
  look_for_departures();
}

void Simulation::look_for_departures() {
  const auto robust = std::find_if(runs_.begin(), runs_.end(), [](const auto& run) { return run->name() == "robust"; });
  if (robust == runs_.end()) return;
  const Snapshot& right = (*robust)->now();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const EngineRun* const engine = runs_[i]->engine();
    if (engine == nullptr || !engine->ended().empty()) continue;
    Departure& departure = departures_[i];
    const Snapshot& now = engine->now();
    if (departure.numbers == 0 && now.hash != right.hash) departure.numbers = step_;
    if (departure.contacts != 0 || !engine->tells_contacts() || same_set_of_contacts(now, right)) continue;
    departure.contacts = step_;
    for (const Impact& impact : now.impacts) departure.of_engine.push_back(impact.touch);
    for (const Impact& impact : right.impacts) departure.of_robust.push_back(impact.touch);
  }
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
