// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <sstream>

#include "catalogue/operation/operation.h"
#include "proptests/infrastructure/simulate/scene_text.h"
#include "proptests/refusal.h"
#include "simulate/trajectory.h"
#include "simulate/world/hash.h"

namespace touchstone::proptests::trajectories_tests {
namespace {

using catalogue::Json;
using simulate::Frame;
using simulate::Scene;
using simulate::Simulation;

const std::vector<std::string> every{"float", "double", "robust"};

const Scene& two_balls() {
  static const Scene scene =
      scene_from(scene_text(R"("steps_per_second":60,"option":2)",
                            R"("gravity":[0,-9.81,0],"room":{"min":[0,0,-1],"max":[2,2,1]},"bodies":[)" +
                                sphere(0.15625, "[0.4375,1.25,0]", "[0.375,-0.9375,0]") + "," +
                                sphere(0.15625, "[1.5625,1.0625,0]", "[-0.6875,-0.4375,0]") + "]"));
  return scene;
}

/// From where the simulation stands to that step; with its header and start if it begins.
std::string written_to(Simulation& simulation, std::uint64_t steps) {
  std::ostringstream out;
  if (simulation.step() == 0) write_header(simulation, out), write_step(simulation, out);
  while (simulation.step() < steps) simulation.advance(), write_step(simulation, out);
  return out.str();
}

const std::string& whole() {
  static const std::string text = [] {
    Simulation simulation(two_balls(), every);
    return written_to(simulation, 300);
  }();
  return text;
}

std::string refusal_of(const std::string& text, const Scene& scene = two_balls(),
                       const std::vector<std::string>& runs = every) {
  Simulation simulation(scene, runs);
  std::istringstream in(text);
  return proptests::refusal_of([&] { read_trajectory(in, simulation, [](const Frame&) {}); });
}

/// The first characters of `from` that stand in that line, replaced.
std::string with(std::string text, std::size_t line, const std::string& from, const std::string& to) {
  std::size_t at = 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  at = text.find(from, at);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("trajectory: cut anywhere and resumed, it is the same bytes") {
  const std::string& text = whole();
  std::size_t end = text.find('\n') + 1;  // the header
  for (const std::size_t cut :
       {std::size_t(0), end - 1, end, end + 1, text.size() / 3, text.size() / 2, text.size() - 1, text.size()}) {
    Simulation simulation(two_balls(), every);
    std::istringstream in(text.substr(0, cut));
    std::uint64_t frames = 0;
    const std::uint64_t length =
        read_trajectory(in, simulation, [&](const Frame& frame) { CHECK(frame.step == frames++); });
    CHECK(length <= cut);
    std::string resumed = text.substr(0, length);
    if (length == end) {  // the header alone: the start is written next
      std::ostringstream out;
      write_step(simulation, out);
      resumed += out.str();
    } else if (length == 0) {
      resumed = written_to(simulation, 0);
    }
    while (simulation.step() < 300) {
      simulation.advance();
      std::ostringstream out;
      write_step(simulation, out);
      resumed += out.str();
    }
    CHECK(resumed == text);
  }
}

TEST_CASE("trajectory: what was resumed knows its drift since the start") {
  Simulation from_start(two_balls(), every), resumed(two_balls(), every);
  written_to(from_start, 300);
  std::istringstream in(whole());
  read_trajectory(in, resumed, [](const Frame&) {});
  CHECK(resumed.step() == 300);
  for (std::size_t i = 0; i < every.size(); ++i) {
    CHECK(resumed.run(i).drift().scheme == from_start.run(i).drift().scheme);
    CHECK(resumed.run(i).drift().rounding == from_start.run(i).drift().rounding);
  }
}

TEST_CASE("trajectory: at the start nothing has drifted") {
  const std::string& text = whole();
  const std::string nothing = R"("drift":{"law":"0","scheme":"0","decision":"0","rounding":"0"})";
  for (const char* drifted : {R"("drift":{"law":"0","scheme":"7","decision":"0","rounding":"0"})",
                              R"("drift":{"law":"-7","scheme":"7","decision":"0","rounding":"0"})",
                              R"("drift":{"law":"0","scheme":"0","decision":"1/2","rounding":"-1/2"})"})
    CHECK_THAT(refusal_of(with(text, 2, nothing, drifted)), ContainsSubstring("0 before the first step"));
}

TEST_CASE("trajectory: of another scene or other runs, with a line missing or a number changed, it is refused") {
  const std::string& text = whole();
  CHECK(refusal_of(text) == "accepted");
  CHECK(refusal_of(text, two_balls(), {"double"}) == "line 1: the trajectory is of another scene, or of other runs");
  CHECK(refusal_of(with(text, 1, "0.9375", "0.9376")) ==
        "line 1: the trajectory is of another scene, or of other runs");
  CHECK(refusal_of(with(text, 4, "{\"step\":2", "{\"step\":3")) == "line 4.step: expected 2, got 3");
  CHECK(refusal_of(with(text, 4, "\"bodies\":[[0", "\"bodies\":[[1")).substr(0, 18) == "line 4.float.hash:");
  CHECK(refusal_of(with(text, 4, "\"energy\":\"", "\"energy\":\"1")).substr(0, 20) == "line 4.float.energy:");
  CHECK(refusal_of(with(text, 4, "\"hash\":\"", "\"hash\":\"0")).substr(0, 18) == "line 4.float.hash:");
  CHECK(refusal_of(with(text, 4, "\"scheme\":\"-", "\"scheme\":\"-1")) ==
        "line 4.float.drift: its parts add up to the change of energy");
  CHECK(refusal_of(with(text, 4, "\"chain\":\"", "\"chain\":\"0")).substr(0, 19) == "line 4.float.chain:");
  CHECK(refusal_of(with(text, 4, "\"float\"", "\"floot\"")) == "line 4.float: missing");
}

TEST_CASE("trajectory: the hash of a state does not depend on the order of bodies, nor on the sign of 0") {
  const auto hash_of = [](const std::string& bodies) {
    const Scene scene = scene_from(scene_text(R"("timestep":1,"option":1)", "\"bodies\":[" + bodies + "]"));
    return simulate::hash_of(scene, scene.start());
  };
  const std::string a = sphere(1, "[0,0,0]", "[1,0,0]"), b = sphere(2, "[5,0,0]", "[0,0,0]");
  const std::uint64_t hash = hash_of(a + "," + b);
  CHECK(hash_of(b + "," + a) == hash);
  CHECK(hash_of(sphere(1, "[0,-0.0,0]", "[1,0,-0.0]") + "," + b) == hash);
  CHECK(hash_of(sphere(2, "[0,0,0]", "[1,0,0]") + "," + sphere(1, "[5,0,0]", "[0,0,0]")) != hash);
  CHECK(hash_of(sphere(1, "[0,0,0]", "[0,1,0]") + "," + b) != hash);
  CHECK(hash_of(sphere(1, "[0,5e-324,0]", "[1,0,0]") + "," + b) != hash);
}

TEST_CASE("trajectory: the hashes of all steps are the same with every compiler and level of optimisation") {
  Simulation simulation(two_balls(), every);
  written_to(simulation, 300);
  CHECK(simulate::in_digits(simulation.run(0).now().chain) == "99a598191bf9bc3e");
  CHECK(simulate::in_digits(simulation.run(1).now().chain) == "6eb419fe3f5d4452");
  CHECK(simulate::in_digits(simulation.run(2).now().chain) == "c6e84091f9e07ef4");
}

TEST_CASE("trajectory: as comma-separated values it has a line a step, run and body") {
  Simulation simulation(two_balls(), {"double"});
  std::ostringstream out;
  simulate::write_csv_header(out);
  write_csv_step(simulation, out);
  CHECK(out.str() ==
        "step,run,body,x,y,z,vx,vy,vz\n"
        "0,double,\"bodies[0]\",0.4375,1.25,0,0.375,-0.9375,0\n"
        "0,double,\"bodies[1]\",1.5625,1.0625,0,-0.6875,-0.4375,0\n");
}

TEST_CASE("trajectory: a quote within a name is written twice in comma-separated values") {
  const std::string ball = sphere(0.25, "[0.5,1,0]", "[0,0,0]");
  const std::string named = R"({"name":"a \"b\", c",)" + ball.substr(1);
  const Scene scene = scene_from(scene_text(R"("steps_per_second":60,"option":2)", "\"bodies\":[" + named + "]"));
  Simulation simulation(scene, {"double"});
  std::ostringstream out;
  write_csv_step(simulation, out);
  CHECK(out.str() == "0,double,\"a \"\"b\"\", c\",0.5,1,0,0,0,0\n");
}

TEST_CASE("trajectory: where two runs part, the question is one that the catalogue answers in these two ways") {
  Simulation simulation(two_balls(), every);
  written_to(simulation, 300);
  REQUIRE(simulation.partings().size() == 2);
  for (const simulate::Parting& parting : simulation.partings()) {
    CHECK(parting.step == 279);
    CHECK(parting.first == "float");
    CHECK(name_of(two_balls(), parting.touch) == "bodies[1] and room.max.x");
    CHECK(parting.by_first.answer["relation"] != parting.by_second.answer["relation"]);
    const catalogue::Operation* operation = catalogue::find_operation(parting.by_first.operation);
    REQUIRE(operation != nullptr);
    for (const simulate::Asked& asked : {parting.by_first, parting.by_second}) {
      const auto question = operation->parse(catalogue::parse_line(catalogue::one_line(asked.question)));
      // Both were right for their own numbers: what came before had moved them apart.
      CHECK(operation->examine(question)->outcome() == asked.answer["relation"]);
    }
  }
}

TEST_CASE("trajectory: what parted two runs is the first other word, not the first other number") {
  // Both see the first particle meet the floor, at times that differ; the second reaches the floor in float, whose
  // velocity is -1, and not in double.
  const Scene scene = scene_from(
      scene_text(R"("timestep":1,"option":2)", floor_of_scene + ",\"bodies\":[" + particle("[0,0.3,0]", "[0,-0.9,0]") +
                                                   "," + particle("[5,1,0]", "[0,-0.999999999,0]") + "]"));
  Simulation simulation(scene, {"float", "double"});
  simulation.advance();
  REQUIRE(simulation.partings().size() == 1);
  const simulate::Parting& parting = simulation.partings()[0];
  CHECK(name_of(scene, parting.touch) == "bodies[1] and floor");
  CHECK(parting.by_first.answer["option_2"]["relation"] == "hit");
  CHECK(parting.by_second.answer["option_2"]["relation"] == "never");
}

TEST_CASE("trajectory: what a run asks, the catalogue takes, and answers as that run was answered") {
  // Spheres and boxes that meet one another and walls, with both options.
  const std::string box = R"({"shape":{"box":{"half_extents":[0.4,0.3,0.2]}},"position":)";
  const std::string boxes =
      box + R"([0.7,1.1,0],"velocity":[-1.3,-2,0.1]},)" + box + R"([-0.6,0.9,0.1],"velocity":[1.1,-1,0]})";
  const std::string balls =
      sphere(0.3, "[0.1,2.7,0]", "[0.3,-2.9,0]") + "," + sphere(0.2, "[0.2,1.9,0.1]", "[0.2,0.7,0]");
  const std::string room =
      R"("gravity":[0,-9.81,0],"walls":[{"normal":[0,1,0],"offset":0},{"normal":[1,2,0],"offset":3}],"bodies":[)";
  std::map<std::string, int> operations;
  for (const auto& [option, bodies] : {std::pair{R"("timestep":0.1,"option":1)", balls + "," + boxes},
                                       {R"("timestep":0.1,"option":2)", balls},
                                       {R"("timestep":0.1,"option":2)", boxes}}) {
    const Scene scene = scene_from(scene_text(option, room + bodies + "]"));
    Simulation simulation(scene, every);
    for (int step = 0; step < 8; ++step) {
      for (std::size_t i = 0; i < every.size(); ++i) {
        for (const simulate::Asked& asked : simulation.run(i).log_from(simulation.run(i).now().state)) {
          const catalogue::Operation& operation = *catalogue::find_operation(asked.operation);
          INFO(every[i] << ": " << asked.operation << " " << asked.question);
          const auto examination =
              operation.examine(operation.parse(catalogue::parse_line(catalogue::one_line(asked.question))));
          const Json answer =
              every[i] == "robust" ? examination->robust() : examination->reference(every[i] == "float");
          REQUIRE((asked.answer.is_string() ? answer[operation.metadata().answer] : answer) == asked.answer);
          ++operations[asked.operation];
        }
      }
      simulation.advance();
    }
  }
  for (const char* name : {"point_plane", "sphere_plane", "sphere_sphere", "sphere_aabb", "aabb_aabb", "contact_state",
                           "swept_sphere_plane", "swept_sphere_sphere", "swept_aabb_aabb", "point_plane_toi"}) {
    INFO(name);
    CHECK(operations[name] > 0);
  }
}

}  // namespace touchstone::proptests::trajectories_tests
