// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "proptests/infrastructure/program/called.h"
#include "proptests/infrastructure/simulate/scene_text.h"

/// touchstone simulate, as it is called.
namespace touchstone::proptests::command_tests {
namespace {

const char* const two_balls = "simulate/scenes/two_balls_in_a_box.json";

std::string text_in(const std::string& file) {
  std::ifstream in(file);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

TEST_CASE("simulate: it tells energy and drift of each run, and what parted two of them") {
  const Called call = called({"simulate", two_balls, "--steps", "300"});
  CHECK(call.code == nothing_found);
  CHECK(call.err.empty());
  for (const char* words :
       {"Two balls in a box", "2 bodies, 6 walls, steps 0 to 300", "\nfloat ", "\ndouble ", "\nrobust ",
        "   law +       scheme +     decision +     rounding",
        "float and double part in step 279: right and room.max.x", "| touchstone ask swept_sphere_plane"})
    CHECK_THAT(call.out, ContainsSubstring(words));
}

TEST_CASE("simulate: it tells how high bodies bounce, and how many times as high as before") {
  const TextFile scene("bounces.json", R"({"touchstone_scene":1,"gravity":[0,-2,0],"response":{"law":"restitution",)"
                                       R"("restitution":0.5},"advance":{"timestep":1,"steps":4,"option":2,)"
                                       R"("motion":"parabola"},"walls":[{"name":"floor","normal":[0,1,0],"offset":0}],)"
                                       R"("bodies":[{"name":"ball","shape":{"particle":{}},"position":[0,1,0]}]})");
  const Called call = called({"simulate", scene.path(), "--runs", "double"});
  CHECK_THAT(call.out,
             ContainsSubstring("heights of bounces\n  double: ball rises above floor by 0.25, 0.0625 (0.25 of "
                               "that before), 0.015625 (0.25 of that before)\n"));
}

TEST_CASE("simulate: where no runs part, that is told; of one run alone there is nothing to tell") {
  const char* const words = "no runs part: all answer the same contacts";
  CHECK_THAT(called({"simulate", two_balls, "--steps", "100"}).out, ContainsSubstring(words));
  CHECK_THAT(called({"simulate", two_balls, "--steps", "300"}).out, !ContainsSubstring(words));
  CHECK_THAT(called({"simulate", two_balls, "--steps", "100", "--runs", "double"}).out, !ContainsSubstring(words));
}

TEST_CASE("simulate: a scene that is no JSON is told by line and column") {
  const auto refused = [](const std::string& text, const std::string& complaint) {
    const TextFile scene("typed.json", text);
    require_refused(called({"simulate", scene.path()}), bad_usage, "typed.json: " + complaint);
  };
  refused("{\n  \"touchstone_scene\": 1,\n  \"bodies\": [1, 2.5,],\n}",
          "line 3, column 21: one JSON object; unexpected \"]\" after a comma");
  refused("{\n  \"touchstone_scene\": 1,\n}", "line 3, column 1: one JSON object; unexpected \"}\" after a comma");
  refused("{\n  \"a\": 1 125\n}", "line 2, column 10: one JSON object; unexpected \"1\"");
  refused("{\n  \"a\": [1", "line 2, column 10: one JSON object; the text ends there");
}

TEST_CASE("simulate: a trajectory cut off in the middle of a line and resumed is the same file") {
  const TextFile whole("whole.jsonl", ""), cut("cut.jsonl", "");
  const auto run = [](const TextFile& file, std::vector<const char*> more) {
    std::vector<const char*> arguments{"simulate", two_balls, "--runs",      "double,robust",
                                       "--steps",  "40",      "--trajectory"};
    arguments.push_back(file.path());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return called(arguments);
  };
  CHECK(run(whole, {}).code == nothing_found);
  const std::string text = text_in(whole.path());
  CHECK(std::count(text.begin(), text.end(), '\n') == 42);
  for (const std::size_t length : {std::size_t(0), std::size_t(100), text.size() / 2, text.size() - 1, text.size()}) {
    std::ofstream(cut.path()) << text.substr(0, length);
    CHECK(run(cut, {"--resume"}).code == nothing_found);
    CHECK(text_in(cut.path()) == text);
  }
  // To standard output, too, and what people read is then elsewhere.
  const Called printed =
      called({"simulate", two_balls, "--runs", "double,robust", "--steps", "40", "--trajectory", "-"});
  CHECK(printed.out == text);
  CHECK_THAT(printed.err, ContainsSubstring("steps 0 to 40"));
}

TEST_CASE("simulate: a page is written, also of what was resumed") {
  const TextFile page("page.html", ""), resumed("resumed.html", ""), trajectory("t.jsonl", "");
  const auto run = [&](const char* steps, const TextFile& file) {
    return called({"simulate", two_balls, "--steps", steps, "--trajectory", trajectory.path(), "--resume", "--page",
                   file.path()});
  };
  CHECK(run("300", page).code == nothing_found);
  CHECK(run("300", resumed).code == nothing_found);
  CHECK_THAT(text_in(page.path()), ContainsSubstring("float and double part in step 279"));
  CHECK(text_in(page.path()) == text_in(resumed.path()));
}

TEST_CASE("simulate: what cannot be done is told in one line") {
  const TextFile bad("bad.json", "{\"touchstone_scene\":1,\"advance\":{\"timestep\":1,\"option\":1},\"bodie\":[]}");
  require_refused(called({"simulate", bad.path()}), bad_usage, "bodie: no such field (did you mean \"bodies\"?)");
  require_refused(called({"simulate", "no/such/scene.json"}), bad_usage, "no/such/scene.json");
  require_refused(called({"simulate", two_balls, "--runs", "duoble"}), bad_usage, "--runs: no run duoble");
  require_refused(called({"simulate", two_balls, "--resume"}), bad_usage, "--resume: needs --trajectory");
  require_refused(called({"simulate", two_balls, "--trajectory", "/no/such/folder/t.jsonl"}), bad_usage,
                  "--trajectory");
  const TextFile other("other.jsonl", "{\"touchstone_trajectory\":1,\"runs\":[\"double\"],\"scene\":{}}\n");
  require_refused(called({"simulate", two_balls, "--trajectory", other.path(), "--resume"}), bad_usage,
                  "line 1: the trajectory is of another scene, or of other runs");
  require_refused(called({"simulate", "simulate/scenes/exact_gas.json", "--steps", "3"}), bad_usage,
                  "an exact gas has no steps");
}

TEST_CASE("simulate: an empty list of runs, and a file for two things, are wrong usage, and nothing is written") {
  require_refused(called({"simulate", two_balls, "--runs", ""}), bad_usage,
                  "--runs: at least one of float, double, robust");
  const std::string text = text_in("simulate/scenes/projectile.json");
  const TextFile scene("scene.json", text);
  const std::string elsewhere =
      (std::filesystem::path(scene.path()).parent_path() / "." / std::filesystem::path(scene.path()).filename())
          .string();
  for (const char* option : {"--trajectory", "--page"})
    for (const char* name : {scene.path(), elsewhere.c_str()})
      require_refused(called({"simulate", scene.path(), option, name}), bad_usage,
                      option + std::string(": ") + name + " is the scene");
  CHECK(text_in(scene.path()) == text);
  const std::string made = elsewhere + ".out";
  require_refused(called({"simulate", scene.path(), "--trajectory", made.c_str(), "--page", made.c_str()}), bad_usage,
                  "is the trajectory, too");
  CHECK(!std::filesystem::exists(made));
}

TEST_CASE("simulate: a device, which may have no end, is not read") {
  require_refused(called({"simulate", "/dev/zero"}), bad_usage, "/dev/zero: cannot be read: is a device");
  require_refused(called({"simulate", two_balls, "--trajectory", "/dev/zero", "--resume"}), bad_usage,
                  "--resume: /dev/zero is no regular file");
}

TEST_CASE("simulate: a page is written where numbers are subnormal, or near the end of the range") {
  const TextFile page("page.html", "");
  const TextFile scene("small.json", R"({"touchstone_scene":1,"advance":{"timestep":1,"option":1},"bodies":[)" +
                                         particle("[1e-310,0,0]", "[1.797693e308,0,0]") + "]}");
  const Called call = called({"simulate", scene.path(), "--steps", "0", "--page", page.path()});
  CHECK(call.code == nothing_found);
  CHECK(call.err.empty());
  CHECK_THAT(text_in(page.path()), ContainsSubstring("1e-310") && ContainsSubstring("1.79769e+308"));
}

TEST_CASE("simulate: a run that cannot go on ends with what was made until then") {
  const TextFile scene("far.json", R"({"touchstone_scene":1,"advance":{"timestep":1,"option":1},"bodies":[)" +
                                       particle("[1e308,0,0]", "[6e307,0,0]") + "]}");
  const Called call = called({"simulate", scene.path(), "--runs", "double", "--steps", "9"});
  CHECK(call.code == bad_usage);
  CHECK_THAT(call.err, ContainsSubstring("step 2, run double: a number is beyond the range"));
  CHECK_THAT(call.out, ContainsSubstring("steps 0 to 1"));
}

TEST_CASE("simulate: an exact gas runs forwards and backwards") {
  const TextFile scene("gas.json", R"({"touchstone_scene":1,"gas":{"side":1048576,"cubes_along":4,"gap":1179648,)"
                                   R"("speed":999,"seed":2,"until":9000}})");
  const Called call = called({"simulate", scene.path()});
  CHECK(call.code == nothing_found);
  for (const char* words : {"64 cubes", "energy               identical", "momentum with walls  identical",
                            "run backwards        identical to the start"})
    CHECK_THAT(call.out, ContainsSubstring(words));
}

}  // namespace touchstone::proptests::command_tests
