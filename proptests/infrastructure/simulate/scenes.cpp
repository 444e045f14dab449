// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "proptests/infrastructure/simulate/scene_text.h"
#include "simulate/gas/gas_scene.h"
#include "simulate/simulation.h"

/// What each scene in simulate/scenes/ should show.
namespace touchstone::proptests::scenes_tests {
namespace {

using simulate::Run;
using simulate::Scene;
using simulate::Simulation;
using simulate::Snapshot;

const std::vector<std::string> every{"float", "double", "robust"};

Scene shipped(const std::string& name) {
  std::ifstream in("simulate/scenes/" + name + ".json");
  REQUIRE(in.good());
  return scene_from(std::string(std::istreambuf_iterator<char>(in), {}));
}

/// Runs the scene to its end; visit sees every run after each step.
template <class Visit>
void play(const Scene& scene, const Visit& visit, const std::vector<std::string>& runs = every) {
  Simulation simulation(scene, runs);
  while (simulation.step() < scene.settings.steps) {
    simulation.advance();
    for (std::size_t i = 0; i < simulation.size(); ++i) visit(simulation.run(i));
  }
}

double y_of(const Run& run, std::size_t body = 0) { return run.now().state[body].position.y; }
double vx_of(const Run& run, std::size_t body) { return run.now().state[body].velocity.x; }

/// The heights at which a falling body turned, by the run.
std::vector<double> tops(const Scene& scene, const std::string& run) {
  std::vector<double> heights, tops;
  double before = 0;
  play(scene,
       [&](const Run& now) {
         const double v = now.now().state[0].velocity.y;
         if (before > 0 && v <= 0) tops.push_back(std::max(heights.back(), y_of(now)));
         before = v;
         heights.push_back(y_of(now));
       },
       {run});
  return tops;
}

/// After the last step of each run.
template <class Check>
void at_the_end(const std::string& name, const Check& check) {
  const Scene scene = shipped(name);
  Simulation simulation(scene, every);
  while (simulation.step() < scene.settings.steps) simulation.advance();
  for (std::size_t i = 0; i < every.size(); ++i) {
    INFO(name << " in " << every[i]);
    check(simulation.run(i));
  }
}

std::size_t contacts_in(const std::string& name, const std::string& run) {
  std::size_t contacts = 0;
  play(shipped(name), [&](const Run& now) { contacts += now.now().impacts.size(); }, {run});
  return contacts;
}

}  // namespace

TEST_CASE("scenes: every file is read, has a title, says what it shows, names pages, and is tested here") {
  std::ifstream in("proptests/infrastructure/simulate/scenes.cpp");
  const std::string tests(std::istreambuf_iterator<char>(in), {});
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator("simulate/scenes")) {
    const std::string name = file.path().stem().string();
    INFO(name);
    if (name == "exact_gas" || name.rfind("gas_", 0) == 0) continue;  // gas.cpp, referee.cpp, and below
    const Scene scene = shipped(name);
    CHECK(!scene.title.empty());
    CHECK(!scene.about.empty());
    CHECK(!scene.deck_pages.empty());
    CHECK(std::is_sorted(scene.deck_pages.begin(), scene.deck_pages.end()));
    CHECK(tests.find("\"" + name + "\"") != std::string::npos);
    ++scenes;
  }
  CHECK(scenes >= 12);
}

TEST_CASE("scenes: option 1 turns a particle above the ground, option 2 at the ground") {
  const auto least = [](const std::string& name) {
    double least = 1;
    play(shipped(name),
         [&](const Run& run) {
           for (const auto& impact : run.now().impacts)
             if (impact.touch.body == 0) least = impact.point.y;
         },
         {"robust"});
    return least;
  };
  CHECK(least("time_of_impact") == 0);
  CHECK(least("ground_plane") == 0);  // the steep one happens to end its fourth step on the ground
  double flat = 0;
  play(shipped("ground_plane"),
       [&](const Run& run) {
         for (const auto& impact : run.now().impacts)
           if (impact.touch.body == 1) flat = impact.point.y;
       },
       {"robust"});
  CHECK(flat < 0);  // where the step would have ended
  at_the_end("ground_plane", [](const Run& run) { CHECK(run.drift().scheme == 0); });
}

TEST_CASE("scenes: a ball in a box keeps each component's size, bit for bit") {
  play(shipped("ball_in_a_box"), [](const Run& run) {
    const auto& v = run.now().state[0].velocity;
    const bool single = run.name() == "float";
    const auto number = [&](double x) { return single ? static_cast<double>(static_cast<float>(x)) : x; };
    CHECK(std::abs(v.x) == number(1.7));
    CHECK(std::abs(v.y) == number(0.9));
    CHECK(std::abs(v.z) == number(0.6));
    CHECK(run.drift().total() == 0);
  });
  CHECK(contacts_in("ball_in_a_box", "robust") > 20);
}

TEST_CASE("scenes: at a slope of 3 : 4 a ball that falls flies off at 24 : 7") {
  at_the_end("slanted_wall", [](const Run& run) { CHECK(run.drift().scheme == 0); });
  bool bounced = false;
  play(shipped("slanted_wall"),
       [&](const Run& run) {
         if (bounced || run.now().impacts.empty()) return;
         bounced = true;
         // v - 2 (v . n / n . n) n = (0, -3) + 24/25 (3, 4)
         CHECK(std::abs(run.now().state[0].velocity.x - 2.88) < 1e-15);
         CHECK(std::abs(run.now().state[0].velocity.y - 0.84) < 1e-15);
       },
       {"robust"});
  CHECK(bounced);
}

TEST_CASE(
    "scenes: a ball that turns before the move rises higher, after it less high, with time of impact about as high") {
  const struct {
    const char* name;
    double heights[3];
  } balls[]{{"bouncing_ball", {1.0736, 1.1499, 1.2289}},  // of a prototype in rationals, in another language
            {"bouncing_ball_after", {0.9264, 0.8556, 0.7875}},
            {"bouncing_ball_impact", {0.9865, 1.0000, 0.9865}}};
  for (const auto& [name, heights] : balls) {
    for (const std::string& run : every) {
      const std::vector<double> found = tops(shipped(name), run);
      REQUIRE(found.size() >= 3);
      for (int i = 0; i < 3; ++i) CHECK(std::abs(found[i] - heights[i]) < 0.0001);
    }
  }
}

TEST_CASE("scenes: with a factor of 0.8 each of the first three tops has about 64 % of the height before") {
  const std::vector<double> found = tops(shipped("bouncing_to_rest"), "robust");
  REQUIRE(found.size() > 3);
  double before = 1;
  for (int i = 0; i < 3; ++i) {
    const double height = found[i] - 0.125;
    CHECK(std::abs(height / before - 0.64) < 0.04);
    before = height;
  }
  at_the_end("bouncing_to_rest", [](const Run& run) { CHECK(y_of(run) < 0.14); });
}

TEST_CASE("scenes: along parabolas each bounce rises to the square of the factor, until the ball slides") {
  std::vector<double> rises;
  play(shipped("bounce_heights"),
       [&](const Run& run) {
         for (const auto& impact : run.now().impacts) rises.push_back(impact.rise);
       },
       {"robust"});
  REQUIRE(rises.size() > 10);
  double height = 1;
  for (const double rise : rises) {
    height *= 0.64;
    CHECK(std::abs(rise / height - 1) < 1e-9);  // places near 0.1 m round by 1e-17, the last heights are 1e-5 m
  }
  // It has bounced at sqrt(2 / g) (1 + 2 e / (1 - e)) s for the last time, and moves on.
  at_the_end("bounce_heights", [](const Run& run) {
    CHECK(std::abs(y_of(run) - 0.125) < 1e-6);
    CHECK(std::abs(run.now().state[0].velocity.y) < 1e-6);
    CHECK(vx_of(run, 0) == 0.5);
    CHECK(abs(run.drift().scheme) < mpq_class(1, 1000000));
    CHECK(run.drift().law < -9);  // all of m g h, 9.81 J
  });
}

TEST_CASE("scenes: a ball among boxes loses no energy by its scheme but what contacts of one step round") {
  at_the_end("ball_and_boxes",
             [](const Run& run) { CHECK(abs(run.drift().scheme) < mpq_class(1, std::int64_t{1} << 40)); });
  CHECK(contacts_in("ball_and_boxes", "robust") > 20);
}

TEST_CASE("scenes: a thrown particle moved along parabolas loses energy to rounding alone") {
  at_the_end("projectile", [](const Run& run) {
    CHECK(run.drift().scheme == 0);
    CHECK(run.drift().decision == 0);
    CHECK(run.drift().rounding != 0);
  });
}

TEST_CASE("scenes: in the cradle the last ball leaves with all of the velocity, and the others stand still") {
  at_the_end("newtons_cradle", [](const Run& run) {
    for (std::size_t ball = 0; ball < 4; ++ball) CHECK(vx_of(run, ball) == 0);
    CHECK(vx_of(run, 4) == 2);
    CHECK(run.drift().total() == 0);
  });
}

TEST_CASE("scenes: a light ball between a heavy one and a wall: energy stays, and the heavy one turns round") {
  at_the_end("unequal_masses", [](const Run& run) {
    CHECK(run.drift().scheme == 0);
    CHECK(vx_of(run, 1) > 0.9);
    CHECK(vx_of(run, 1) < 1.01);
  });
}

TEST_CASE("scenes: balls that stick have one velocity, the momentum they had, and less energy") {
  at_the_end("sticking_balls", [](const Run& run) {
    CHECK(vx_of(run, 0) == -0.25);  // (1 * 2 - 3 * 1) / 4
    CHECK(vx_of(run, 1) == -0.25);
    CHECK(run.now().momentum[0] == -1);
    CHECK(run.drift().scheme == 0);
    CHECK(run.drift().law == mpq_class(-27, 8));  // 1/2 * 4 * (1/4)^2 - (1/2 * 1 * 2^2 + 1/2 * 3 * 1^2)
  });
}

TEST_CASE("scenes: two balls in a box: float decides otherwise at step 279, double and robust part later") {
  const Scene scene = shipped("two_balls_in_a_box");
  Simulation simulation(scene, every);
  while (simulation.step() < scene.settings.steps) simulation.advance();
  REQUIRE(simulation.partings().size() == 3);
  CHECK(simulation.partings()[0].step == 279);
  CHECK(simulation.partings()[1].step == 279);
  CHECK(simulation.partings()[2].first == "double");
  CHECK(simulation.partings()[2].step > 500);
}

TEST_CASE(
    "scenes: a billiard break loses no energy by its scheme but what several contacts of a ball in one step round, "
    "and float's runs of contacts part") {
  const Scene scene = shipped("billiard_break");
  Simulation simulation(scene, every);
  std::uint64_t pairs = 0;
  while (simulation.step() < scene.settings.steps) {
    simulation.advance();
    for (const auto& impact : simulation.run(2).now().impacts) pairs += impact.touch.wall ? 0 : 1;
  }
  CHECK(pairs > 20);
  // A number of 53 digits is off by 2^-53 of itself at most, and an energy by little more than twice that.
  const mpq_class once = simulation.run(2).now().energy / (std::int64_t{1} << 51);
  for (std::size_t i = 0; i < every.size(); ++i) CHECK(abs(simulation.run(i).drift().scheme) < pairs * once);
  REQUIRE(!simulation.partings().empty());
  CHECK(simulation.partings()[0].first == "float");
}

TEST_CASE("scenes: option 1 lets a fast bullet through a thin wall, option 2 sends it back with half its speed") {
  CHECK(contacts_in("fast_bullet", "robust") == 0);
  at_the_end("fast_bullet", [](const Run& run) {
    CHECK(run.now().state[0].position.x > 100);
    CHECK(vx_of(run, 0) == 900);
  });
  at_the_end("fast_bullet_impact", [](const Run& run) {
    CHECK(run.now().state[0].position.x < -0.01);
    CHECK(vx_of(run, 0) == -450);
  });
  at_the_end("fast_box", [](const Run& run) {
    CHECK(run.now().state[0].position.x < -0.02);
    CHECK(vx_of(run, 0) == -45);
  });
}

TEST_CASE(
    "scenes: a soft spring throws back, a stiff one gives energy that was not there, a damped one comes to rest") {
  at_the_end("penalty_soft", [](const Run& run) {
    CHECK(run.now().energy > 9);
    CHECK(run.now().energy < 10);
  });
  at_the_end("penalty_stiff", [](const Run& run) {
    CHECK(run.now().energy > 100);
    CHECK(run.drift().scheme > 100);
    CHECK(abs(run.drift().rounding) < 1);
  });
  at_the_end("penalty_damped", [](const Run& run) {
    CHECK(std::abs(y_of(run) + 9.81 / 400) < 1e-6);  // k depth = m g
    CHECK(std::abs(run.now().state[0].velocity.y) < 1e-6);
  });
}

TEST_CASE("scenes: a box at rest never moves, not by a bit") {
  play(shipped("resting_box"), [](const Run& run) {
    CHECK(y_of(run) == 0.25);
    CHECK(run.now().state[0].velocity.y == 0);
    CHECK(run.drift().total() == 0);
  });
}

TEST_CASE(
    "scenes: answered once each, the contacts of a stack do not hold it; answered forty times they hold it longer") {
  at_the_end("resting_stack", [](const Run& run) { CHECK(y_of(run, 2) < 1); });
  at_the_end("resting_stack_passes", [](const Run& run) {
    CHECK(y_of(run, 2) > 1.2);
    CHECK(y_of(run, 2) <= 1.25);
  });
}

TEST_CASE("scenes: a row of boxes hands on three quarters of each speed") {
  const Scene scene = shipped("domino_row");
  std::vector<double> first_speed(8, 0);
  play(scene,
       [&](const Run& run) {
         for (std::size_t box = 0; box < 8; ++box)
           if (first_speed[box] == 0) first_speed[box] = vx_of(run, box);
         CHECK(run.now().momentum[0] - 2 < mpq_class(1, std::int64_t{1} << 48));
       },
       {"robust"});
  double expected = 2;
  for (std::size_t box = 1; box < 8; ++box) {
    expected *= 0.75;
    CHECK(std::abs(first_speed[box] - expected) < 1e-12);
  }
}

TEST_CASE("scenes: a ball comes down the stairs, bouncing, and falls no deeper than the ground") {
  at_the_end("ball_on_stairs", [](const Run& run) {
    CHECK(run.now().state[0].position.x > 3);
    CHECK(y_of(run) < 0.5);
    CHECK(y_of(run) > -2.1);
  });
  CHECK(contacts_in("ball_on_stairs", "robust") >= 5);
}

TEST_CASE("scenes: a thousand cubes keep energy and momentum, and return to where they began") {
  std::ifstream in("simulate/scenes/exact_gas.json");
  const auto gas = simulate::gas::read_gas(catalogue::parse_line(std::string(std::istreambuf_iterator<char>(in), {})));
  CHECK(gas.cubes.size() == 1000);
  std::ostringstream out;
  CHECK(run_gas(gas, out));
}

}  // namespace touchstone::proptests::scenes_tests
