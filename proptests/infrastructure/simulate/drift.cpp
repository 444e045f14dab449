// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "proptests/infrastructure/simulate/scene_text.h"
#include "simulate/simulation.h"

namespace touchstone::proptests::drift_tests {
namespace {

using catalogue::exact_value;
using simulate::Drift;
using simulate::Scene;
using simulate::Simulation;

const std::string gravity = "\"gravity\":[0,-9.81,0],";
const std::vector<std::string> every{"float", "double", "robust"};

Scene bouncing(const std::string& advance) {
  return scene_from(scene_text("\"steps_per_second\":60," + advance,
                               gravity + floor_of_scene + ",\"bodies\":[" + particle("[0,1,0]", "[0,0,0]") + "]"));
}

}  // namespace

TEST_CASE(
    "drift: law, scheme, decisions and rounding add up exactly to the change of energy, at every step and in all") {
  for (const char* advance : {R"("option":1)", R"("option":1,"turn":"after_move")", R"("option":2)",
                              R"("option":1,"motion":"move_then_accelerate")"}) {
    const Scene scene = bouncing(advance);
    Simulation simulation(scene, every);
    std::vector<mpq_class> start;
    for (std::size_t i = 0; i < every.size(); ++i) start.push_back(simulation.run(i).now().energy);
    for (int step = 0; step < 120; ++step) {
      std::vector<mpq_class> before;
      for (std::size_t i = 0; i < every.size(); ++i) before.push_back(simulation.run(i).now().energy);
      simulation.advance();
      for (std::size_t i = 0; i < every.size(); ++i) {
        const simulate::Run& run = simulation.run(i);
        REQUIRE(run.now().drift.total() == run.now().energy - before[i]);
        REQUIRE(run.drift().total() == run.now().energy - start[i]);
      }
    }
  }
}

TEST_CASE("drift: what restitution is meant to take is the law's, and none of it the scheme's") {
  // Two balls of masses 1 and 3 with a closing speed of 4 lose (1 - e^2) m/2 v^2 of the reduced mass 3/4; the floor
  // takes (1 - e^2) of the other ball's 1/2 * 2 * 1^2.
  std::string heavy = sphere(1, "[3,5,0]", "[0,0,0]"), falling = sphere(1, "[9,1.5,0]", "[0,-1,0]");
  heavy.insert(1, "\"mass\":3,"), falling.insert(1, "\"mass\":2,");
  for (const char* option : {R"("timestep":1,"option":2)", R"("timestep":0.5,"option":1)"}) {
    const Scene scene = scene_from(
        scene_text(option, R"("response":{"law":"restitution","restitution":0.5},)" + floor_of_scene + ",\"bodies\":[" +
                               sphere(1, "[0,5,0]", "[4,0,0]") + "," + heavy + "," + falling + "]"));
    Simulation simulation(scene, every);
    simulation.advance();
    for (std::size_t i = 0; i < every.size(); ++i) {
      REQUIRE(simulation.run(i).now().impacts.size() == 2);
      CHECK(simulation.run(i).now().drift.law == mpq_class(-3, 4) * (mpq_class(3, 8) * 16 + 1));
      CHECK(simulation.run(i).now().drift.scheme == 0);
    }
  }
}

TEST_CASE("drift: a free step's scheme gains -h^2 g^2 / 2, its opposite, or nothing, by its motion") {
  const mpq_class h = exact_value(1.0 / 60), g = exact_value(9.81), gain = h * h * g * g / 2;
  const std::pair<const char*, mpq_class> motions[]{
      {"accelerate_then_move", -gain}, {"move_then_accelerate", gain}, {"parabola", 0}};
  for (const auto& [motion, expected] : motions) {
    const Scene scene = bouncing(std::string(R"("option":1,"motion":")") + motion + "\"");
    Simulation simulation(scene, {"double", "robust"});
    simulation.advance();
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(simulation.run(i).now().drift.scheme == expected);
      CHECK(simulation.run(i).now().drift.decision == 0);
    }
  }
}

TEST_CASE("drift: without gravity, and bouncing elastically, the scheme has no error, and exact numbers no rounding") {
  const Scene scene = scene_from(
      scene_text(R"("timestep":0.125,"option":2)", R"("room":{"min":[-1,-1,-1],"max":[1,1,1]},"bodies":[)" +
                                                       sphere(0.25, "[0.5,0.25,0]", "[0.75,-1.5,0.125]") + "," +
                                                       sphere(0.25, "[-0.5,0.3125,0]", "[0.3,0.9,0]") + "]"));
  Simulation simulation(scene, every);
  std::size_t contacts = 0;
  for (int step = 0; step < 100; ++step, contacts += simulation.run(2).now().impacts.size()) simulation.advance();
  CHECK(contacts > 20);
  for (std::size_t i = 0; i < every.size(); ++i) CHECK(simulation.run(i).drift().scheme == 0);
  CHECK(simulation.run(1).drift().rounding != 0);
}

TEST_CASE("drift: a decision that rounding changed is a decision, however small the rounding") {
  // In double y + h v is 0, so that the particle turns; exactly it is above the floor, and goes on falling.
  const double h = 1.0 / 60, g = 9.81;
  double v = 0, y = 0;
  for (int n = 1; n < 100 && y == 0; ++n) {
    const double sixteenth = -n / 16.0, fast = sixteenth + h * -g;
    if (exact_value(-(h * fast)) + exact_value(h) * exact_value(fast) > 0) v = sixteenth, y = -(h * fast);
  }
  REQUIRE(y > 0);
  const Scene scene = scene_from(
      scene_text(R"("steps_per_second":60,"option":1)",
                 gravity + floor_of_scene + ",\"bodies\":[" +
                     particle("[0," + catalogue::decimal(y) + ",0]", "[0," + catalogue::decimal(v) + ",0]") + "]"));
  Simulation simulation(scene, {"double"});
  simulation.advance();
  const Drift& drift = simulation.run(0).now().drift;
  REQUIRE(simulation.run(0).now().impacts.size() == 1);
  CHECK(abs(drift.decision) > mpq_class(1, 1000));
  CHECK(abs(drift.rounding) < mpq_class(1, 1000000000));
}

TEST_CASE("drift: momentum is exact: what a bounce of two balls changes of it is rounding alone") {
  const Scene scene =
      scene_from(scene_text(R"("timestep":1,"option":2)", "\"bodies\":[" + sphere(1, "[0,0,0]", "[4,0,0]") + "," +
                                                              sphere(1, "[3,0,0]", "[0,0,0.5]") + "]"));
  Simulation simulation(scene, {"robust"});
  simulation.advance();
  REQUIRE(simulation.run(0).now().impacts.size() == 1);
  const auto& [x, y, z] = simulation.run(0).now().momentum;
  CHECK(abs(x - 4) < mpq_class(1, std::int64_t{1} << 50));
  CHECK(abs(z - mpq_class(1, 2)) < mpq_class(1, std::int64_t{1} << 50));
}

TEST_CASE("drift: what a spring holds is energy") {
  const Scene scene = scene_from(
      scene_text(R"("timestep":0.5,"option":1)", R"("response":{"law":"penalty","stiffness":6},)" + floor_of_scene +
                                                     ",\"bodies\":[" + particle("[0,-2,0]", "[1,0,0]") + "]"));
  Simulation simulation(scene, {"robust"});
  CHECK(simulation.run(0).now().energy == mpq_class(25, 2));
}

}  // namespace touchstone::proptests::drift_tests
