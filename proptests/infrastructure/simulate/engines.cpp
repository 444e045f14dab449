// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "proptests/infrastructure/program/called.h"
#include "proptests/infrastructure/simulate/scene_text.h"
#include "report/pages/simulation_page.h"

/// Foreign engines beside the runs of a scene.
namespace touchstone::proptests::engines_tests {
namespace {

using catalogue::Json;

const char* const bouncing_ball = "simulate/scenes/bouncing_ball.json";
const char* const two_balls = "simulate/scenes/two_balls_in_a_box.json";
const std::string example = "python3 examples/simulate_engine.py";

std::string misbehaving(const std::string& behaviour) {
  return "python3 proptests/infrastructure/simulate/misbehaving_engine.py " + behaviour;
}

std::vector<Json> lines_of(const std::string& file) {
  std::ifstream in(file);
  std::vector<Json> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

mpq_class fraction(const Json& text) { return mpq_class(text.get<std::string>()); }

Called with_engine(const char* scene, const std::string& engine, std::vector<const char*> more = {}) {
  std::vector<const char*> arguments{"simulate", scene, "--steps", "5", "--engine", engine.c_str()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return called(arguments);
}

}  // namespace

TEST_CASE("engines: one that makes the scene's own step has the numbers of the run in double") {
  // Its step is option 1 with `after_move`, in the same order of operations, but for the reflection of p. 68, whose
  // last bits may differ: until the first contact nothing may.
  const TextFile file("engine.jsonl", "");
  const Called call = called({"simulate", "simulate/scenes/bouncing_ball_after.json", "--steps", "60", "--engine",
                              example.c_str(), "--trajectory", file.path()});
  CHECK(call.code == nothing_found);
  for (const char* words : {"its own", "\nball in Python ", "thresholds that remain: balls do not meet one another"})
    CHECK_THAT(call.out, ContainsSubstring(words));
  const auto lines = lines_of(file.path());
  REQUIRE(lines.size() == 62);
  CHECK(lines[0]["runs"] == Json({"float", "double", "robust", "ball in Python"}));
  CHECK(lines[0]["engines"]["ball in Python"]["number"] == "binary64");
  bool met = false;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Json &run = lines[i]["double"], &engine = lines[i]["ball in Python"];
    CHECK(engine["contacts"].size() == run["contacts"].size());
    met = met || !run["contacts"].empty();
    if (!met) CHECK(engine["bodies"] == run["bodies"]);
    // What the exact step gains, and what is its own, add up to the change of energy.
    if (i == 1) continue;
    CHECK(fraction(engine["energy"]) - fraction(lines[i - 1]["ball in Python"]["energy"]) ==
          fraction(engine["drift"]["scheme"]) + fraction(engine["drift"]["own"]));
    CHECK_FALSE(engine["drift"].contains("rounding"));
  }
  CHECK(met);
}

TEST_CASE("engines: where it first has other numbers and other contacts than robust is told") {
  // Its bodies stand still, so that the first step already has other numbers; it tells no contacts.
  const Called still = with_engine(two_balls, misbehaving("behaves"));
  CHECK(still.code == nothing_found);
  for (const char* words :
       {"other numbers than robust from step 1", "not told", "thresholds that remain: none declared"})
    CHECK_THAT(still.out, ContainsSubstring(words));
  CHECK(still.out.find("other contacts") == std::string::npos);
  // Balls that fly through one another: robust answers their contact in the step in which they meet.
  const TextFile scene(
      "meet.json", scene_text(R"("timestep":0.5,"option":1)", "\"bodies\":[" + sphere(1, "[-2,0,0]", "[1,0,0]") + "," +
                                                                  sphere(1, "[2,0,0]", "[-1,0,0]") + "]"));
  CHECK_THAT(with_engine(scene.path(), example).out,
             ContainsSubstring("other contacts than robust in step 2: it answers none; robust answers bodies[0] and "
                               "bodies[1]"));
}

TEST_CASE("engines: what the scene needs and the engine lacks is unsupported, and no failure") {
  const Called call = with_engine(two_balls, misbehaving("lacks_spheres"));
  CHECK(call.code == nothing_found);
  CHECK(call.err.empty());
  CHECK_THAT(call.out, ContainsSubstring("misbehaving 1: unsupported: spheres, walls\n"));
  CHECK_THAT(with_engine(two_balls, misbehaving("declines")).out,
             ContainsSubstring("misbehaving 1: unsupported: more than one body\n"));
}

TEST_CASE("engines: one that misbehaves ends with one sentence, and the other runs go on") {
  const std::pair<const char*, const char*> all[]{
      {"crashes", "step 3: signal 11"},
      {"exits", "step 3: exit code 1: no licence"},
      {"hangs", "step 3: no answer in 5 s"},
      {"says_nan", "step 3: "},
      {"says_null", "step 3: bodies[0][1]: "},
      {"is_infinite", "step 3: bodies[0][1]: "},
      {"forgets_a_body", "step 3: bodies: "},
      {"forgets_a_number", "step 3: bodies[0]: "},
      {"is_late", "step 3: step: expected 3"},
      {"meets_nobody", "step 3: contacts[0].other: expected an integer below 2"},
      {"meets_itself", "step 3: contacts[0]: a body meets another one"},
      {"gives_up", "step 3: error: \"no solution\""},
      {"half_a_line", "step 3: exit code 1"},
      {"says_nothing", "exit code 1: no licence"},
      {"greets_badly", "exit code 1"},
      {"is_nameless", "first line: engine: missing"},
      {"misspells", "first line: canot: no such field (did you mean \"cannot\"?)"},
      {"lacks_what_is_none", "spheers: no feature of scenes (did you mean \"spheres\"?)"},
  };
  for (const auto& [behaviour, sentence] : all) {
    CAPTURE(behaviour);
    const TextFile file("engine.jsonl", "");
    const Called call = with_engine(two_balls, misbehaving(behaviour), {"--trajectory", file.path()});
    CHECK(call.code == engine_failed);
    CHECK(std::count(call.err.begin(), call.err.end(), '\n') == 1);
    CHECK_THAT(call.err, ContainsSubstring("touchstone: engine ") && ContainsSubstring(sentence));
    CHECK_THAT(call.out, ContainsSubstring("steps 0 to 5") && ContainsSubstring(sentence));
    const auto lines = lines_of(file.path());
    REQUIRE(lines.size() == 7);
    CHECK(lines[6].contains("robust"));
    CHECK(lines[6]["ended"].size() == 1);
    CHECK(lines[3].contains("ended") == (call.err.find("step 3") == std::string::npos));
  }
}

TEST_CASE("engines: other lines are passed over, names stay apart, and several run side by side") {
  CHECK(with_engine(two_balls, misbehaving("babbles")).code == nothing_found);
  const std::string named = misbehaving("is_called_robust");
  const Called call = with_engine(two_balls, named, {"--engine", named.c_str(), "--engine", example.c_str()});
  CHECK(call.code == nothing_found);
  for (const char* words : {"\nrobust again  ", "\nrobust again again  ", "\nball in Python  "})
    CHECK_THAT(call.out, ContainsSubstring(words));
}

TEST_CASE("engines: one cannot go on from a file") {
  const TextFile file("engine.jsonl", "");
  require_refused(with_engine(two_balls, example, {"--trajectory", file.path(), "--resume"}), bad_usage,
                  "--resume: an engine cannot resume from a file");
}

TEST_CASE("engines: the page plays them too, as far as they came") {
  const TextFile page("page.html", "");
  const std::string crashing = misbehaving("crashes");
  with_engine(bouncing_ball, crashing, {"--engine", example.c_str(), "--page", page.path()});
  std::ifstream in(page.path());
  const std::string text(std::istreambuf_iterator<char>(in), {});
  for (const char* words : {"ball in Python", "misbehaving 1", "step 3: signal 11"})
    CHECK_THAT(text, ContainsSubstring(words));
}

TEST_CASE("engines: those of engines/ make the steps of a scene, where they are built") {
  const TextFile scene("fall.json",
                       R"({"touchstone_scene":1,"gravity":[0,-8,0],"advance":{"timestep":0.125,"option":1},)"
                       R"("bodies":[)" +
                           sphere(0.5, "[0,64,0]", "[1,0,0]") + "]}");
  const char* const folder = std::getenv("TOUCHSTONE_ENGINE_PROGRAMS");
  const std::string programs = std::string(folder == nullptr ? "build/release/engines" : folder) + "/simulate_";
  const std::string script = "build/npm/node_modules/touchstone-npm-engines/simulate.mjs";
  struct Engine {
    std::string file, argument;
    double height;
  };
  // All numbers are short. Velocities are -1 to -5; who accelerates first falls (1 + 2 + 3 + 4 + 5) / 8, who moves
  // first (0 + 1 + 2 + 3 + 4) / 8. Rapier accelerates first in each of four parts of a step, its documented number of
  // solver iterations: (1 + ... + 20) / 128.
  const Engine all[]{{programs + "bullet", "", 62.125}, {programs + "box2d", "", 62.125},
                     {programs + "ode", "", 62.125},    {programs + "chipmunk", "", 62.75},
                     {script, " planck", 62.125},       {script, " matter-js", 62.125},
                     {script, " cannon-es", 62.125},    {script, " @dimforge/rapier3d-compat", 62.359375}};
  std::string missing;
  for (const auto& [program, argument, height] : all) {
    const std::string command = (program == script ? "node " : "") + program + argument;
    CAPTURE(command);
    if (!std::filesystem::exists(program)) {
      missing += "\n  " + command;
      continue;
    }
    const TextFile file("engine.jsonl", "");
    CHECK(with_engine(scene.path(), command, {"--trajectory", file.path()}).code == nothing_found);
    const auto lines = lines_of(file.path());
    REQUIRE(lines.size() == 7);
    const Json& last = lines[6][lines[0]["runs"][3].get<std::string>()];
    CHECK(last["bodies"][0][1] == height);
    CHECK(last["bodies"][0][4] == -5);
    // matter-js counts in pixels and milliseconds, so that a velocity of 1 m/s is rounded.
    if (argument != " matter-js") CHECK(last["bodies"] == Json::array({{0.625, height, 0, 1, -5, 0}}));
    CHECK(last["contacts"].empty());
  }
  if (!missing.empty()) WARN("engines: not built or not installed (./dev engines):" << missing);
}

}  // namespace touchstone::proptests::engines_tests
