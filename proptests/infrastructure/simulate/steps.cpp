// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "proptests/infrastructure/simulate/scene_text.h"
#include "simulate/simulation.h"

namespace touchstone::proptests::steps_tests {
namespace {

using simulate::Scene;
using simulate::Simulation;
using simulate::State;

/// After each step, what every run has: all three where all numbers are exact.
void require_states(const Scene& scene, const std::vector<std::vector<double>>& expected) {
  Simulation simulation(scene, {"float", "double", "robust"});
  for (const std::vector<double>& numbers : expected) {
    simulation.advance();
    for (std::size_t i = 0; i < simulation.size(); ++i) {
      INFO(simulation.run(i).name() << " after step " << simulation.step());
      CHECK(numbers_of(simulation.run(i).now().state) == numbers);
    }
  }
}

Scene of(const std::string& advance, const std::string& bodies, const std::string& more = "") {
  return scene_from(scene_text(advance, more + floor_of_scene + ",\"bodies\":[" + bodies + "]"));
}

const std::string gravity = "\"gravity\":[0,-2,0],";

}  // namespace

TEST_CASE("step: p. 23, option 1: a particle turns before or after it moved") {
  const std::string falling = particle("[0,1,0]", "[1,-1,0]");
  // It would reach the floor at the end of the second step.
  require_states(of(R"("timestep":0.5,"option":1)", falling),
                 {{0.5, 0.5, 0, 1, -1, 0}, {1, 1, 0, 1, 1, 0}, {1.5, 1.5, 0, 1, 1, 0}});
  require_states(of(R"("timestep":0.5,"option":1,"turn":"after_move")", falling),
                 {{0.5, 0.5, 0, 1, -1, 0}, {1, 0, 0, 1, 1, 0}, {1.5, 0.5, 0, 1, 1, 0}});
}

TEST_CASE("step: p. 23, option 2: a particle turns where it meets the floor, within the step") {
  require_states(of(R"("timestep":1,"option":2)", particle("[0,0.75,0]", "[1,-1,0]")),
                 {{1, 0.25, 0, 1, 1, 0}, {2, 1.25, 0, 1, 1, 0}});
}

TEST_CASE("step: option 2: of two walls the one that is met first is answered first, whichever is listed first") {
  const std::string below = R"({"normal":[0,1,0],"offset":0})", ahead = R"({"normal":[-1,0,0],"offset":1.5})";
  for (const std::string& walls : {below + "," + ahead, ahead + "," + below}) {
    // At the floor after half of the step, at the other wall after three quarters.
    require_states(scene_from(scene_text(R"("timestep":1,"option":2)", "\"walls\":[" + walls + "],\"bodies\":[" +
                                                                           particle("[0,1,0]", "[2,-2,0]") + "]")),
                   {{1, 1, 0, -2, 2, 0}});
  }
}

TEST_CASE("step: gravity enters before the move, after it, or as a parabola") {
  const std::string high = particle("[0,9,0]", "[0,1,0]");
  require_states(of(R"("timestep":0.5,"option":1)", high, gravity), {{0, 9, 0, 0, 0, 0}, {0, 8.5, 0, 0, -1, 0}});
  require_states(of(R"("timestep":0.5,"option":1,"motion":"move_then_accelerate")", high, gravity),
                 {{0, 9.5, 0, 0, 0, 0}, {0, 9.5, 0, 0, -1, 0}});
  require_states(of(R"("timestep":0.5,"option":1,"motion":"parabola")", high, gravity),
                 {{0, 9.25, 0, 0, 0, 0}, {0, 9, 0, 0, -1, 0}});
}

TEST_CASE("step: p. 69-70: two balls, one heavy, with restitution and stuck together") {
  const std::string light = sphere(1, "[0,5,0]", "[4,0,0]");
  std::string heavy = sphere(1, "[3,5,0]", "[0,0,0]");
  heavy.insert(1, "\"mass\":3,");
  // They meet after a quarter of the step.
  const auto with_law = [&](const std::string& law) {
    return of(R"("timestep":1,"option":2)", light + "," + heavy, "\"response\":{" + law + "},");
  };
  require_states(with_law(R"("law":"restitution","restitution":1)"), {{-0.5, 5, 0, -2, 0, 0, 4.5, 5, 0, 2, 0, 0}});
  require_states(with_law(R"("law":"restitution","restitution":0)"), {{1.75, 5, 0, 1, 0, 0, 3.75, 5, 0, 1, 0, 0}});
  require_states(with_law(R"("law":"stick")"), {{1.75, 5, 0, 1, 0, 0, 3.75, 5, 0, 1, 0, 0}});
}

TEST_CASE("step: p. 72-73: a spring pushes a particle that is behind its wall, and a damper slows it") {
  const auto behind = [](const std::string& law) {
    return of(R"("timestep":0.5,"option":1)", particle("[0,-1,0]", "[0,-4,0]"),
              "\"response\":{\"law\":\"penalty\"," + law + "},");
  };
  require_states(behind(R"("stiffness":2)"), {{0, -2.5, 0, 0, -3, 0}});
  require_states(behind(R"("stiffness":2,"damping":1)"), {{0, -1.5, 0, 0, -1, 0}});
}

TEST_CASE("step: boxes bounce on the axis on which they overlap least; a fixed one stays") {
  const auto box = [](const std::string& more, const std::string& position) {
    return R"({"shape":{"box":{"half_extents":[1,1,1]}},"position":)" + position + more + "}";
  };
  const std::string two = box(",\"velocity\":[0,-2,0]", "[0.5,5,0]") + "," + box(",\"fixed\":true", "[0,2,0]");
  require_states(of(R"("timestep":1,"option":1)", two), {{0.5, 7, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0}});
  require_states(of(R"("timestep":1,"option":2)", two), {{0.5, 5, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0}});
}

TEST_CASE("step: what touches and slides, leaves or rests is no contact") {
  for (const char* option : {R"("timestep":0.5,"option":1)", R"("timestep":0.5,"option":2)"}) {
    require_states(of(option, sphere(1, "[0,1,0]", "[0,1,0]") + "," + sphere(1, "[5,1,0]", "[1,0,0]") + "," +
                                  sphere(1, "[9,1,0]", "[0,0,0]")),
                   {{0, 1.5, 0, 0, 1, 0, 5.5, 1, 0, 1, 0, 0, 9, 1, 0, 0, 0, 0}});
  }
}

TEST_CASE("step: where products overflow, the formula meets a wall that is far away, and robust does not") {
  // N . p = 2e310 - 1e310 is infinity - infinity, NaN: neither front nor back.
  const Scene scene = scene_from(
      scene_text(R"("timestep":1,"option":1)", R"("walls":[{"normal":[1e150,1e150,0],"offset":0}],"bodies":[)" +
                                                   particle("[2e160,-1e160,0]", "[-1,-1,0]") + "]"));
  Simulation simulation(scene, {"double", "robust"});
  simulation.advance();
  CHECK(simulation.run(0).now().state[0].velocity.x > 0);
  CHECK(simulation.run(1).now().state[0].velocity.x == -1);
}

TEST_CASE("step: with sort and sweep, and with a tree, the steps are those of all pairs, to the last bit") {
  for (const char* option : {R"("option":1)", R"("option":2)"}) {
    std::string balls;
    for (int i = 0; i < 27; ++i) {
      const auto at = [](int k, double shift) { return catalogue::decimal(k * 1.125 + shift); };
      balls +=
          (i == 0 ? "" : ",") +
          sphere(0.5, "[" + at(i % 3, 0.0625 * (i / 9)) + "," + at(i / 3 % 3, 0.03125 * i) + "," + at(i / 9, 0) + "]",
                 "[" + catalogue::decimal(3 - i % 7) + "," + catalogue::decimal(i % 5 - 2.5) + "," +
                     catalogue::decimal(i % 3) + "]");
    }
    const auto scene = [&](const std::string& broad_phase) {
      return scene_from(scene_text("\"timestep\":0.0625," + std::string(option) + broad_phase,
                                   R"("room":{"min":[-1,-1,-1],"max":[4,4,4]},"bodies":[)" + balls + "]"));
    };
    const Scene plain = scene(""), swept = scene(R"(,"broad_phase":"sort_and_sweep")"),
                tree = scene(R"(,"broad_phase":"tree")");
    Simulation one(plain, {"float", "double", "robust"}), other(swept, {"float", "double", "robust"}),
        third(tree, {"float"});  // whose formulas are wrong by most
    std::size_t contacts = 0;
    for (int step = 0; step < 24; ++step) {
      one.advance();
      other.advance();
      third.advance();
      REQUIRE(one.run(0).now().chain == third.run(0).now().chain);
      for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(one.run(i).now().chain == other.run(i).now().chain);
        for (const auto& impact : one.run(i).now().impacts) contacts += impact.touch.wall ? 0 : 1;
      }
    }
    CHECK(contacts > 50);
  }
}

TEST_CASE("step: option 2: what the exact step carries from moment to moment keeps 53 digits") {
  // Two balls that bounce from each other and from walls: each moment but the first is computed from the last.
  const Scene scene = scene_from(
      scene_text(R"("timestep":4,"option":2)", R"("room":{"min":[-1,-1,-1],"max":[1.25,1.25,1]},"bodies":[)" +
                                                   sphere(0.5, "[-0.5,-0.5,0]", "[1,0.5,0]") + "," +
                                                   sphere(0.5, "[0.5,0.5,0]", "[-0.5,0.25,0]") + "]"));
  Simulation simulation(scene, {"robust"});
  simulation.advance();
  CHECK(simulation.run(0).now().impacts.size() == 29);
  const mpq_class& scheme = simulation.run(0).now().drift.scheme;
  CHECK(scheme != 0);
  // A number of 53 digits is off by 2^-53 of itself at most, and an energy by little more than twice that.
  CHECK(abs(scheme) < 29 * simulation.run(0).now().energy / (std::int64_t{1} << 51));
  // The last contact has two centers and two velocities of 53 digits: its numbers have some hundreds, not millions.
  CHECK(mpz_sizeinbase(scheme.get_den_mpz_t(), 2) < 10'000);
}

TEST_CASE("step: a number beyond the range and too many moments end a run, which is told by step and name") {
  const auto error_of = [](const Scene& scene) -> std::string {
    Simulation simulation(scene, {"double"});
    try {
      for (int step = 0; step < 3; ++step) simulation.advance();
    } catch (const simulate::StepError& wrong) {
      return wrong.what();
    }
    return "";
  };
  CHECK(error_of(of(R"("timestep":1,"option":1)", particle("[1e308,1,0]", "[6e307,0,0]"))) ==
        "step 2, run double: a number is beyond the range");
  const std::string between = R"("walls":[{"normal":[0,1,0],"offset":0},{"normal":[0,-1,0],"offset":1}],"bodies":[)";
  CHECK(error_of(scene_from(scene_text(R"("timestep":1,"option":2,"moments":7)",
                                       between + particle("[0,0.5,0]", "[0,7,0]") + "]"))) == "");
  CHECK(error_of(scene_from(
            scene_text(R"("timestep":1,"option":2,"moments":6)", between + particle("[0,0.5,0]", "[0,7,0]") + "]"))) ==
        "step 1, run double: more than 6 moments (advance.moments)");
}

}  // namespace touchstone::proptests::steps_tests
