// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <sstream>

#include "geometry/invalid_input.h"
#include "proptests/catch.h"
#include "simulate/run.h"
#include "simulate/step.h"

namespace touchstone::proptests::two_particles_tests {
namespace {

using simulate::State;

simulate::Scene scene_of(const std::string& particles, double timestep = 0.5) {
  return simulate::read_scene(
      catalogue::parse_line("{\"touchstone_scene\":1,\"timestep\":" + std::to_string(timestep) +
                            ",\"walls\":[{\"normal\":[0,2,0],\"offset\":0}],\"particles\":" + particles + "}"));
}

std::vector<double> numbers_of(const State<double>& state) {
  std::vector<double> numbers;
  for (const auto& [p, v] : state) numbers.insert(numbers.end(), {p.x, p.y, p.z, v.x, v.y, v.z});
  return numbers;
}

std::string refusal_of(const std::string& scene) {
  try {
    simulate::read_scene(catalogue::parse_line(scene));
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "read";
}

}  // namespace

TEST_CASE("simulate: p. 23, option 1: two particles and a wall, by hand") {
  // The first reaches the ground at the end of the second step, turns before it moves, and flies up; the second never
  // comes near.
  const simulate::Scene scene =
      scene_of(R"([{"position":[0,1,0],"velocity":[1,-1,0]},{"position":[3,4,0],"velocity":[0,0,2]}])");
  const State<double> heights[]{{{{0.5, 0.5, 0}, {1, -1, 0}}, {{3, 4, 1}, {0, 0, 2}}},
                                {{{1, 1, 0}, {1, 1, 0}}, {{3, 4, 2}, {0, 0, 2}}},
                                {{{1.5, 1.5, 0}, {1, 1, 0}}, {{3, 4, 3}, {0, 0, 2}}}};
  State<double> in_double = scene.particles, by_robust = scene.particles;
  for (const State<double>& expected : heights) {
    in_double = simulate::step_by_formulas(scene, in_double);
    by_robust = simulate::step_by_robust(scene, by_robust);
    CHECK(numbers_of(in_double) == numbers_of(expected));
    CHECK(numbers_of(by_robust) == numbers_of(expected));
  }
}

TEST_CASE("simulate: a particle in a wall that leaves it, or slides along it, is left alone") {
  const simulate::Scene scene =
      scene_of(R"([{"position":[0,-1,0],"velocity":[0,1,0]},{"position":[0,0,0],"velocity":[1,0,0]}])");
  const State<double> expected{{{0, -0.5, 0}, {0, 1, 0}}, {{0.5, 0, 0}, {1, 0, 0}}};
  CHECK(numbers_of(simulate::step_by_formulas(scene, scene.particles)) == numbers_of(expected));
  CHECK(numbers_of(simulate::step_by_robust(scene, scene.particles)) == numbers_of(expected));
}

TEST_CASE("simulate: where products overflow, the formula meets a wall that is far away, and robust does not") {
  // N . p = 2e310 - 1e310 is infinity - infinity, NaN: neither front nor back.
  const simulate::Scene scene = simulate::read_scene(catalogue::parse_line(
      R"({"touchstone_scene":1,"timestep":1,"walls":[{"normal":[1e150,1e150,0],"offset":0}],
          "particles":[{"position":[2e160,-1e160,0],"velocity":[-1,-1,0]}]})"));
  CHECK(simulate::step_by_robust(scene, scene.particles)[0].velocity.x == -1);
  CHECK(simulate::step_by_formulas(scene, scene.particles)[0].velocity.x > 0);
}

TEST_CASE("simulate: a run prints each step in three arithmetics") {
  std::ostringstream out;
  simulate::run(scene_of(R"([{"position":[0,1,0],"velocity":[0,-1,0]}])"), 2, out);
  std::istringstream lines(out.str());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto json = catalogue::Json::parse(line);
    CHECK(json["step"] == count);
    for (const char* run : {"float", "double", "robust"}) CHECK(json[run].size() == 1);
  }
  CHECK(count == 3);
}

TEST_CASE("simulate: what a scene must be is told by field and rule") {
  CHECK(refusal_of(R"({"touchstone_scene":1,"timestep":1,"walls":[]})") == "particles: missing");
  CHECK(refusal_of(R"({"touchstone_scene":2,"timestep":1,"walls":[],"particles":[]})") ==
        "touchstone_scene: 1, the version that this program reads");
  CHECK(refusal_of(R"({"touchstone_scene":1,"timestep":0,"walls":[],"particles":[]})") == "timestep: greater than 0");
  CHECK(refusal_of(R"({"touchstone_scene":1,"timestep":1,"walls":[{"normal":[0,0,0],"offset":0}],"particles":[]})") ==
        "walls[0].normal: nonzero normal");
}

}  // namespace touchstone::proptests::two_particles_tests
