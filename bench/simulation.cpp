// SPDX-License-Identifier: Apache-2.0
// Steps of 10,000 balls in a room, by the formulas in double, by robust, and by Bullet and ODE where they are
// installed. items_per_second are steps.
#include "bench/timing.h"
#include "simulate/step.h"
#if defined(TOUCHSTONE_BENCH_BULLET)
#include "engines/simulated_bullet.h"
#endif
#if defined(TOUCHSTONE_BENCH_ODE)
#include "engines/simulated_ode.h"
#endif

namespace touchstone::bench {
namespace {

using namespace simulate;

constexpr std::size_t balls = 10000, along = 22;  // 22^3 places of a lattice
constexpr double radius = 0.25, place = 0.75;

/// Uniform in [0, 1), of 32 bits, by the generator of Lehmer: the same with every library.
class Random {
 public:
  double next() {
    state_ = state_ * 48271 % 2147483647;
    return static_cast<double>(state_) / 2147483647;
  }

 private:
  std::uint64_t state_ = 1;
};

Scene balls_in_a_room() {
  Scene scene;
  scene.gravity = {0, -9.81, 0};
  scene.settings.timestep = 1.0 / 60;
  scene.settings.broad_phase = BroadPhase::tree;
  const double side = place * along;
  for (double Vector3d::*axis : {&Vector3d::x, &Vector3d::y, &Vector3d::z}) {
    Vector3d normal{};
    normal.*axis = 1;
    scene.walls.push_back({"", {normal, 0}});
    normal.*axis = -1;
    scene.walls.push_back({"", {normal, side}});
  }
  Random random;
  for (std::size_t i = 0; i < balls; ++i) {
    const auto at = [&](std::size_t k) {
      return radius + 0.01 + place * static_cast<double>(k) + (place - 2 * radius - 0.02) * random.next();
    };
    SceneBody body;
    body.shape = Shape::sphere;
    body.radius = radius;
    const double x = at(i % along), y = at(i / along % along), z = at(i / along / along);
    const double vx = 4 * random.next() - 2, vy = 4 * random.next() - 2, vz = 4 * random.next() - 2;
    body.start = {{x, y, z}, {vx, vy, vz}};
    scene.bodies.push_back(body);
  }
  return scene;
}

const Scene& scene() {
  static const Scene scene = balls_in_a_room();
  return scene;
}

template <class By>
void time_steps(benchmark::State& bench) {
  const World<By> world(scene());
  State<double> state = scene().start();
  std::size_t contacts = 0, steps = 0;
  for (auto _ : bench) {
    auto stepped = step(world, state);
    state = std::move(stepped.state);
    contacts += stepped.impacts.size();
    ++steps;
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
  bench.SetLabel(std::to_string(contacts / steps) + " contacts a step");
}

void time_broad_phase(benchmark::State& bench) {
  const World<Formulas<double>> world(scene());
  State<double> state = scene().start();
  for (int i = 0; i < 60; ++i) state = step(world, state).state;
  std::size_t pairs = 0;
  for (auto _ : bench) pairs = world.touches(state, state).size();
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
  bench.SetLabel(std::to_string(pairs) + " pairs and walls");
}

#if defined(TOUCHSTONE_BENCH_BULLET) || defined(TOUCHSTONE_BENCH_ODE)
simulated::Scene for_engines() {
  simulated::Scene converted{false, scene().settings.timestep, 1, {0, -9.81, 0}, {}, {}};
  for (const auto& [name, plane] : scene().walls)
    converted.walls.push_back({{plane.normal.x, plane.normal.y, plane.normal.z}, plane.offset});
  for (const SceneBody& body : scene().bodies) {
    const auto& [p, v] = body.start;
    converted.bodies.push_back({true, false, radius, 1, {}, {p.x, p.y, p.z}, {v.x, v.y, v.z}});
  }
  return converted;
}

template <class Engine>
void time_engine(benchmark::State& bench, Engine& engine) {
  simulated::Contacts contacts(balls);
  for (auto _ : bench) {
    engine.step(contacts);
    contacts.forget();
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
}
#endif

#if defined(TOUCHSTONE_BENCH_BULLET)
void time_bullet(benchmark::State& bench) {
  simulated::Bullet engine(for_engines());
  time_engine(bench, engine);
}
BENCHMARK(time_bullet)->Name("simulation_10000/bullet")->Unit(benchmark::kMillisecond);
#endif
#if defined(TOUCHSTONE_BENCH_ODE)
void time_ode(benchmark::State& bench) {
  simulated::Ode engine(for_engines(), /*quick=*/true);
  time_engine(bench, engine);
}
BENCHMARK(time_ode)->Name("simulation_10000/ode")->Unit(benchmark::kMillisecond);
#endif
BENCHMARK(time_steps<Formulas<double>>)->Name("simulation_10000/double")->Unit(benchmark::kMillisecond);
BENCHMARK(time_steps<Robust>)->Name("simulation_10000/robust")->Unit(benchmark::kMillisecond);
BENCHMARK(time_broad_phase)->Name("simulation_10000/broad_phase")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace touchstone::bench

BENCHMARK_MAIN();
