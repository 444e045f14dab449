// SPDX-License-Identifier: Apache-2.0
#include "simulate/summary.h"

#include <fmt/format.h>

#include "catalogue/numbers/ulps.h"
#include "simulate/hash.h"

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

}  // namespace

Summary::Summary(const Simulation& simulation)
    : simulation_(simulation), first_(simulation.step()), contacts_(simulation.size()) {}

void Summary::count() {
  for (std::size_t i = 0; i < contacts_.size(); ++i) contacts_[i] += simulation_.run(i).now().impacts.size();
}

void Summary::print(std::ostream& out) const {
  const Scene& scene = simulation_.scene();
  if (!scene.title.empty()) out << scene.title << '\n';
  out << fmt::format("{} bodies, {} walls, steps {} to {} of {}\n\n", scene.bodies.size(), scene.walls.size(), first_,
                     simulation_.step(), catalogue::decimal(scene.settings.timestep));
  out << fmt::format("{:8}{:>14}{:>14}   = {:>12} + {:>12} + {:>12}{:>10}  {}\n", "run", "energy", "drift", "scheme",
                     "decision", "rounding", "contacts", "hash of all steps");
  for (std::size_t i = 0; i < simulation_.size(); ++i) {
    const Run& run = simulation_.run(i);
    const auto& [scheme, decision, rounding] = run.drift();
    out << fmt::format("{:8}{:14.6g}{:14.6g}   = {:12.4g} + {:12.4g} + {:12.4g}{:10}  {}\n", run.name(),
                       in_double(run.now().energy), in_double(run.drift().total()), in_double(scheme),
                       in_double(decision), in_double(rounding), contacts_[i], in_digits(run.now().chain));
  }
  if (!simulation_.partings().empty()) out << '\n';
  for (const Parting& parting : simulation_.partings()) print_parting(scene, parting, out);
}

}  // namespace touchstone::simulate
