// SPDX-License-Identifier: Apache-2.0
// Steps of 10,000 balls in a room, by the formulas in double, by robust, and by Bullet and ODE if they are installed.
// items_per_second counts steps. Also measures the memory for each further body, including a run that also holds the
// exact step and its rationals.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/timing.h"
#include "simulate/run.h"
#if defined(TOUCHSTONE_BENCH_BULLET)
#include "engines/simulated_bullet.h"
#endif
#if defined(TOUCHSTONE_BENCH_ODE)
#include "engines/simulated_ode.h"
#endif

namespace touchstone::bench {
namespace {

using namespace simulate;

constexpr std::size_t balls = 10000;
constexpr double radius = 0.25, place = 0.75;

/// Uniform in [0, 1) with 32 bits, by Lehmer's generator: the same with every library.
class Random {
 public:
  double next() {
    state_ = state_ * 48271 % 2147483647;
    return static_cast<double>(state_) / 2147483647;
  }

 private:
  std::uint64_t state_ = 1;
};

Scene balls_in_a_room(std::size_t many) {
  const auto along = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(many))));
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
  for (std::size_t i = 0; i < many; ++i) {
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
  static const Scene scene = balls_in_a_room(balls);
  return scene;
}

template <class By>
void time_steps(benchmark::State& bench) {
  const World<By> world(scene());
  State<double> state = scene().start();
  Nearby nearby;
  std::size_t contacts = 0, steps = 0;
  for (auto _ : bench) {
    auto stepped = step(world, state, nullptr, nullptr, &nearby);
    state = std::move(stepped.state);
    contacts += stepped.impacts.size();
    ++steps;
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
  bench.SetLabel(std::to_string(contacts / steps) + " contacts a step");
}

/// Its part of `time_steps`. `kept`: objects persist from one step to the next; otherwise everything is made anew.
template <bool kept>
void time_broad_phase(benchmark::State& bench) {
  const World<Formulas<double>> world(scene());
  State<double> state = scene().start();
  Nearby of_steps, nearby;
  std::size_t pairs = 0;
  for (auto _ : bench) {
    bench.PauseTiming();
    state = step(world, state, nullptr, nullptr, &of_steps).state;
    if (!kept) nearby = {};
    bench.ResumeTiming();
    pairs = world.touches(state, state, nearby).size();
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(bench.iterations()));
  bench.SetLabel(std::to_string(pairs) + " pairs and walls");
}

/// The peak memory, in bytes, of a process that does nothing but this work.
template <class Work>
double most_memory(const Work& work) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    work();
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto kilobytes = static_cast<double>(used.ru_maxrss);
    _exit(write(ends[1], &kilobytes, sizeof kilobytes) == sizeof kilobytes ? 0 : 1);
  }
  double kilobytes = 0;
  if (read(ends[0], &kilobytes, sizeof kilobytes) != sizeof kilobytes) std::abort();
  waitpid(child, nullptr, 0);
  close(ends[0]), close(ends[1]);
  return kilobytes * 1024;
}

/// The extra memory of 40,000 bodies over 10,000, per body, after five steps, including the scene.
template <class Work>
void measure_memory(benchmark::State& bench, const Work& work) {
  for (auto _ : bench) {
    const double few = most_memory([&] { work(balls_in_a_room(10000)); });
    const double many = most_memory([&] { work(balls_in_a_room(40000)); });
    bench.counters["bytes_a_body"] = (many - few) / 30000;
  }
}

template <class By>
void memory_of_steps(benchmark::State& bench) {
  measure_memory(bench, [](const Scene& scene) {
    const World<By> world(scene);
    using Real = typename By::Number;
    State<Real> state = scene.start();
    Nearby nearby;
    for (int i = 0; i < 5; ++i) state = step(world, state, nullptr, nullptr, &nearby).state;
  });
}
void memory_of_run(benchmark::State& bench) {
  measure_memory(bench, [](const Scene& scene) {
    const auto run = run_of("robust", scene);
    for (int i = 0; i < 5; ++i) run->advance();
  });
}
BENCHMARK(memory_of_steps<Formulas<double>>)->Name("simulation_memory/double")->Iterations(1);
BENCHMARK(memory_of_steps<Robust>)->Name("simulation_memory/robust")->Iterations(1);
BENCHMARK(memory_of_run)->Name("simulation_memory/run_of_robust")->Iterations(1);

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
BENCHMARK(time_broad_phase<true>)->Name("simulation_10000/broad_phase")->Unit(benchmark::kMillisecond);
BENCHMARK(time_broad_phase<false>)->Name("simulation_10000/broad_phase_anew")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace touchstone::bench

BENCHMARK_MAIN();
