// SPDX-License-Identifier: Apache-2.0
#include "simulate/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/numbers/ulps.h"
#include "simulate/world/hash.h"

namespace touchstone::simulate {
namespace {

double in_double(const mpq_class& x) { return catalogue::nearest(x); }

void print_parting(const Scene& scene, const Parting& parting, std::ostream& out) {
  out << fmt::format("{} and {} part in step {}: {}\n", parting.first, parting.second, parting.step,
                     name_of(scene, parting.touch));
  for (const auto& [name, asked] : {std::pair{parting.first, parting.by_first}, {parting.second, parting.by_second}})
    out << fmt::format("  {} answers {}\n    echo '{}' | touchstone ask {}\n", name, catalogue::one_line(asked.answer),
                       catalogue::one_line(asked.question), asked.operation);
}

std::string listed(const std::vector<std::string>& texts, const char* none) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all.empty() ? none : all;
}

std::string names_of(const Scene& scene, const std::vector<Touch>& touches) {
  std::vector<std::string> names;
  for (const Touch& touch : touches) {
    const std::string name = name_of(scene, touch);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  constexpr std::size_t most = 6;
  if (names.size() > most) names.resize(most), names.emplace_back("...");
  return listed(names, "none");
}

void print_engine(const Simulation& simulation, std::size_t i, std::ostream& out) {
  const EngineRun& engine = *simulation.run(i).engine();
  out << '\n' << engine.name() << ": ";
  if (!engine.began()) {
    out << engine.ended() << '\n';
    return;
  }
  const Departure& departure = simulation.departure(i);
  out << (engine.hello().binary32 ? "binary32" : "binary64")
      << "; thresholds that remain: " << listed(engine.hello().thresholds, "none declared") << '\n';
  if (departure.numbers != 0) out << fmt::format("  other numbers than robust from step {}\n", departure.numbers);
  if (departure.contacts != 0)
    out << fmt::format("  other contacts than robust in step {}: it answers {}; robust answers {}\n",
                       departure.contacts, names_of(simulation.scene(), departure.of_engine),
                       names_of(simulation.scene(), departure.of_robust));
  if (!engine.ended().empty()) out << "  ended: " << engine.ended() << '\n';
}

}  // namespace

Summary::Summary(const Simulation& simulation)
    : simulation_(simulation), first_(simulation.step()), runs_(simulation.size()) {}

void Summary::count() {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (!simulation_.run(i).ended().empty()) continue;
    for (const Impact& impact : simulation_.run(i).now().impacts) count(runs_[i], impact);
  }
}

void Summary::count(OfRun& run, const Impact& impact) {
  ++run.contacts;
  const auto& [wall, body, other] = impact.touch;
  if (!wall || !(impact.rise > 0)) {
    run.last.erase(body);
    if (!wall) run.last.erase(other);
    return;
  }
  const auto before = run.last.find(body);
  std::optional<double> ratio;
  if (before != run.last.end() && before->second.first == other) ratio = impact.rise / before->second.second;
  run.last[body] = {other, impact.rise};
  run.bounces[{body, other}].push_back({impact.rise, ratio});
}

void Summary::print_bounces(std::size_t run, std::ostream& out) const {
  constexpr std::size_t most_lines = 4, most_heights = 5;
  const Scene& scene = simulation_.scene();
  std::size_t lines = 0;
  for (const auto& [places, bounces] : runs_[run].bounces) {
    if (lines++ == most_lines) {
      out << fmt::format("  and {} more\n", runs_[run].bounces.size() - most_lines);
      return;
    }
    const auto& [body, wall] = places;
    out << fmt::format("  {}: {} rises above {} by", simulation_.run(run).name(), scene.bodies[body].name,
                       scene.walls[wall].name);
    for (std::size_t i = 0; i < std::min(bounces.size(), most_heights); ++i) {
      out << fmt::format("{} {:.6g}", i == 0 ? "" : ",", bounces[i].rise);
      if (bounces[i].ratio) out << fmt::format(" ({:.6g} of that before)", *bounces[i].ratio);
    }
    out << (bounces.size() > most_heights ? " ...\n" : "\n");
  }
}

void Summary::print(std::ostream& out) const {
  const Scene& scene = simulation_.scene();
  if (!scene.title.empty()) out << scene.title << '\n';
  out << fmt::format("{} bodies, {} walls, steps {} to {} of {}\n\n", scene.bodies.size(), scene.walls.size(), first_,
                     simulation_.step(), catalogue::decimal(scene.settings.timestep));
  const std::vector<std::string> names = simulation_.names();
  std::size_t width = 8;
  bool engines = false;
  for (std::size_t i = 0; i < names.size(); ++i)
    width = std::max(width, names[i].size() + 2), engines = engines || simulation_.run(i).engine() != nullptr;
  out << fmt::format("{:{}}{:>14}{:>14}   = {:>12} + {:>12} + {:>12} + {:>12}{}{:>10}  {}\n", "run", width, "energy",
                     "drift", "law", "scheme", "decision", "rounding", engines ? " +      its own" : "", "contacts",
                     "hash of all steps");
  for (std::size_t i = 0; i < simulation_.size(); ++i) {
    const Run& run = simulation_.run(i);
    const EngineRun* const engine = run.engine();
    if (engine != nullptr && !engine->began()) continue;
    const auto& [law, scheme, decision, rounding, own] = run.drift();
    out << fmt::format("{:{}}{:14.6g}{:14.6g}   = {:12.4g} + {:12.4g}", run.name(), width, in_double(run.now().energy),
                       in_double(run.drift().total()), in_double(law), in_double(scheme));
    if (engine == nullptr) {
      out << fmt::format(" + {:12.4g} + {:12.4g}{:{}}{:10}", in_double(decision), in_double(rounding), "",
                         engines ? 15 : 0, runs_[i].contacts);
    } else {
      out << fmt::format("{:33} {:12.4g}{:>10}", " +", in_double(own),
                         engine->tells_contacts() ? std::to_string(runs_[i].contacts) : "not told");
    }
    out << "  " << in_digits(run.now().chain) << '\n';
  }
  for (std::size_t i = 0; i < simulation_.size(); ++i)
    if (simulation_.run(i).engine() != nullptr) print_engine(simulation_, i, out);
  const auto bounced = [](const OfRun& run) { return !run.bounces.empty(); };
  if (std::any_of(runs_.begin(), runs_.end(), bounced)) out << "\nheights of bounces\n";
  for (std::size_t i = 0; i < runs_.size(); ++i) print_bounces(i, out);
  if (simulation_.none_parted()) out << "\nno runs part: all answer the same contacts\n";
  if (!simulation_.partings().empty()) out << '\n';
  for (const Parting& parting : simulation_.partings()) print_parting(scene, parting, out);
}

}  // namespace touchstone::simulate
