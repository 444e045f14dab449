// SPDX-License-Identifier: Apache-2.0
#include "simulate/run.h"

#include <cstring>

#include "simulate/world/hash.h"

namespace touchstone::simulate {
namespace {

template <class By>
class RunOf : public Run {
 public:
  using Real = typename By::Number;

  RunOf(const std::string& name, const Scene& scene, const Run* other) : Run(name, scene), world_(scene) {
    begin(in_double(in_arithmetic(scene.start())), other);
  }

  Log log_from(const State<double>& state) const override {
    Log log;
    step(world_, in_arithmetic(state), nullptr, &log);
    return log;
  }

 private:
  Stepped<double> step_from(const State<double>& state) override {
    Stepped<Real> made = step(world_, in_arithmetic(state), nullptr, nullptr, &nearby_);
    return {in_double(made.state), std::move(made.impacts)};
  }

  template <class To, class From>
  static State<To> changed(const State<From>& state) {
    const auto number = [](From x) { return static_cast<To>(x); };
    State<To> result;
    for (const auto& [p, v] : state)
      result.push_back({catalogue::converted<To>(p, number), catalogue::converted<To>(v, number)});
    return result;
  }
  static State<Real> in_arithmetic(const State<double>& state) { return changed<Real>(state); }
  static State<double> in_double(const State<Real>& state) { return changed<double>(state); }

  World<By> world_;
  Nearby nearby_;
};

bool same_bits(const State<double>& a, const State<double>& b) {
  static_assert(sizeof(Particle<double>) == 6 * sizeof(double));
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Particle<double>)) == 0;
}

std::vector<Touch> touches_of(const std::vector<Impact>& impacts) {
  std::vector<Touch> touches;
  for (const Impact& impact : impacts) touches.push_back(impact.touch);
  return touches;
}

}  // namespace

void Run::describe(const State<double>& state) {
  const State<Exact> exact = in_exact(state);
  now_.state = state;
  now_.energy = energy(scene_, exact);
  now_.momentum = momentum(scene_, exact);
  now_.hash = hash_of(scene_, state);
}

void Run::begin(const State<double>& state, const Run* other) {
  if (other != nullptr && same_bits(state, other->now_.state)) {
    now_ = other->now_;
    return;
  }
  describe(state);
  now_.chain = chained(0, now_.hash);
}

Stepped<Exact> Run::ideal_step(const State<Exact>& start) {
  try {
    if (!exact_) exact_.emplace(scene_);
    return step(*exact_, start, nullptr, nullptr, &nearby_exact_);
  } catch (const StepError& wrong) {
    throw StepError("the exact step from its state: " + std::string(wrong.what()));
  }
}

void Run::restore(const Snapshot& then, const Drift& drift) {
  describe(then.state);
  now_.chain = then.chain;
  drift_ = drift;
}

void Run::advance() {
  try {
    const State<Exact> start = in_exact(now_.state);
    const mpq_class before = now_.energy;
    Stepped<double> made = step_from(now_.state);
    const auto ideal = ideal_step(start);
    const mpq_class unrounded = energy(scene_, ideal.state);
    const bool agreed = engine() != nullptr || touches_of(ideal.impacts) == touches_of(made.impacts);
    const mpq_class followed = agreed ? unrounded : energy(scene_, step(*exact_, start, &made.impacts).state);
    now_.impacts = std::move(made.impacts);
    describe(made.state);
    now_.chain = chained(now_.chain, now_.hash);
    now_.drift = {ideal.law, unrounded - before - ideal.law, followed - unrounded, now_.energy - followed};
    if (engine() != nullptr) std::swap(now_.drift.rounding, now_.drift.own);
    drift_ += now_.drift;
  } catch (const std::exception& wrong) {
    if (engine() != nullptr) throw StepError(wrong.what());
    throw StepError("run " + name_ + ": " + wrong.what());
  }
}

std::unique_ptr<Run> run_of(const std::string& name, const Scene& scene, const Run* other) {
  if (name == "float") return std::make_unique<RunOf<Formulas<float>>>(name, scene, other);
  if (name == "double") return std::make_unique<RunOf<Formulas<double>>>(name, scene, other);
  return std::make_unique<RunOf<Robust>>(name, scene, other);
}

}  // namespace touchstone::simulate
