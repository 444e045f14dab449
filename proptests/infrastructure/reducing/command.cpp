// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "audit/reducing/same_finding.h"
#include "catalogue/codec/json.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// The command, with engines that are wrong on purpose.
namespace touchstone::proptests::reduce_command_tests {
namespace {

/// Asks `answer(input)`, an expression of Python over the input.
std::string engine_in_python(const std::string& operation, const std::string& body) {
  return "import json, os, sys\njson.loads(sys.stdin.readline())\nprint(json.dumps({'engine': 'planted', 'ops': ['" +
         operation +
         "'], 'boundary': 'closed'}), flush=True)\nfor line in sys.stdin:\n    question = json.loads(line)\n    i = "
         "question['input']\n" +
         body + "\n    print(json.dumps({'id': question['id'], 'answer': answer}), flush=True)\n";
}

/// A ball of so many rings, and a point in it or not.
Json ball_and_point(int rings) {
  Json vertices = Json::array({{0.01, 0.02, 1}}), faces = Json::array();
  for (int i = 1; i <= rings; ++i)
    for (int k = 0; k < rings; ++k) {
      const double down = std::numbers::pi * i / (rings + 1), round = 2 * std::numbers::pi * k / rings;
      vertices.push_back({std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down)});
    }
  vertices.push_back({0.02, 0.01, -1});
  const int last = rings * rings + 1;
  const auto at = [rings](int ring, int k) { return 1 + ring * rings + k % rings; };
  for (int k = 0; k < rings; ++k) {
    faces.push_back({0, at(0, k), at(0, k + 1)});
    faces.push_back({last, at(rings - 1, k + 1), at(rings - 1, k)});
    for (int i = 0; i + 1 < rings; ++i) {
      faces.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      faces.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  return Json::object({{"mesh", {{"vertices", vertices}, {"faces", faces}}}, {"point", {0.25, 0.125, 0.0625}}});
}

Json reduced_line(const Called& call) {
  INFO(call.err);
  REQUIRE(call.code == nothing_found);
  return parse_own_line(call.out);
}

/// Two rings of so many vertices that overlap, without a vertex of the one in the other among the first.
std::string two_rings(int count) {
  Json rings = Json::object();
  for (const auto& [name, shift] : {std::pair{"a", 0.0}, std::pair{"b", 0.6}}) {
    for (int i = 0; i < count; ++i) {
      const double round = 2 * std::numbers::pi * i / count, far = 1 + 0.3 * std::sin(17 * round);
      rings[name].push_back({shift + far * std::cos(round), shift / 2 + far * std::sin(round)});
    }
  }
  return one_line(rings);
}

}  // namespace

TEST_CASE("reduce: a mesh on which an engine errs because of a face far away becomes a tetrahedron") {
  // Wrong where a face has a vertex of z > 0.9.
  const TextFile script("far.py",
                        engine_in_python("point_in_polyhedron",
                                         "    v = i['mesh']['vertices']\n    far = any(v[k][2] > 0.9 for f in "
                                         "i['mesh']['faces'] for k in f)\n    answer = {'location': 'outside' "
                                         "if far else 'inside'}"));
  const TextFile question("ball.json", one_line(ball_and_point(40)));
  const std::string engine = std::string("python3 ") + script.path();
  std::string first;
  for (const char* jobs : {"1", "3"}) {
    const Called call = called({"reduce", "point_in_polyhedron", question.path(), "--engine", engine.c_str(),
                                "--timeout", "60", "--jobs", jobs});
    const Json line = reduced_line(call);
    CHECK(line["before"]["mesh.faces"] == 3200);
    CHECK(line["after"]["mesh.faces"] == 4);
    CHECK(line["after"]["mesh.vertices"] == 4);
    CHECK(line["truth"] == Json{{"location", "inside"}});
    CHECK(line["engine"]["answer"] == Json{{"location", "outside"}});
    CHECK(line["engine"]["cause"] == "algorithm");
    CHECK(line["finished"] == true);
    if (first.empty()) first = call.out;
    CHECK(call.out == first);
  }
}

TEST_CASE("reduce: polygons of 2,000 vertices become triangles") {
  const TextFile script("never.py", engine_in_python("polygon_polygon", "    answer = {'contact': 'disjoint'}"));
  const TextFile question("rings.json", two_rings(2000));
  const std::string engine = std::string("python3 ") + script.path();
  const Json line = reduced_line(called(
      {"reduce", "polygon_polygon", question.path(), "--engine", engine.c_str(), "--timeout", "60", "--jobs", "2"}));
  CHECK(line["before"]["a"] == 2000);
  CHECK(line["after"]["a"] == 3);
  CHECK(line["after"]["b"] == 3);
  CHECK(line["truth"] == Json{{"contact", "overlapping"}});
}

TEST_CASE("reduce: a crash stays the same crash") {
  // Exit code 3 because of one number, 4 because of another: both are in the question, and then it is 3.
  const char* const engine = R"(read greeting; echo '{"engine":"planted","ops":["convex_hull"]}'
while read -r question; do case "$question" in *7.25*) exit 3;; *5.5*) exit 4;; esac
id=${question#*:}; echo "{\"id\":${id%%,*},\"unsupported\":true}"; done)";
  const TextFile question("points.json", R"({"points":[[0.5,0,0],[4,1,2],[1,7.25,1],[5.5,2,3],[9.75,3.5,1],[2,2,8]]})");
  const Json line = reduced_line(
      called({"reduce", "convex_hull", question.path(), "--engine", engine, "--timeout", "60", "--jobs", "1"}));
  CHECK(line["input"] == parse_own_line(R"({"points":[[0,7.25,0]]})"));
  CHECK(line["engine"]["verdict"] == "invalid");
  CHECK_THAT(line["engine"]["remark"].get<std::string>(), StartsWith("exit code 3"));
}

TEST_CASE("reduce: a command of the user's decides") {
  const TextFile question("points.json", R"({"points":[[0.5,0.25],[4,1],[1,7.25],[5.5,2],[9.75,3.5],[2,8.125]]})");
  const Json line = reduced_line(called(
      {"reduce", "convex_hull_2d", question.path(), "--until", "grep -q 7.25", "--jobs", "2", "--allow-degenerate"}));
  CHECK(line["input"] == parse_own_line(R"({"points":[[0,7.25]]})"));
  CHECK_FALSE(line.contains("engine"));
  // A line with its operation and its input around the question is taken as well.
  const TextFile whole("line.json", R"({"op":"convex_hull_2d","input":{"points":[[1,7.25],[3,4]]},"answer":null})");
  CHECK(reduced_line(called({"reduce", "convex_hull_2d", whole.path(), "--until", "grep -q 7.25"}))["input"] ==
        parse_own_line(R"({"points":[[0,7.25]]})"));
  require_refused(called({"reduce", "convex_hull", whole.path()}), bad_usage, "op: expected convex_hull");
  require_refused(called({"reduce", "convex_hull_2d", question.path(), "--until", "grep -q 7.5"}), bad_usage,
                  "--until: the command does not end with exit code 0 on the question");
}

TEST_CASE("reduce: the formula in float goes on failing by rounding") {
  const TextFile question("turn.json", R"({"p0":[0.3,0.1],"p1":[1.3,2.1],"p":[0.8,1.1]})");
  const Json line =
      reduced_line(called({"reduce", "orientation", question.path(), "--with", "reference,float", "--jobs", "1"}));
  CHECK(line["engine"]["name"] == "reference in float");
  CHECK(line["engine"]["cause"] == "rounding");
  for (const auto& [name, point] : line["input"].items())
    for (const Json& number : point) CHECK(double{static_cast<float>(number.get<double>())} == number.get<double>());
}

TEST_CASE("reduce: what it found is written as files that hold") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_reduced");
  const TextFile question("ray.json", one_line(ball_and_point(6)));
  const TextFile script("out.py", engine_in_python("point_in_polyhedron", "    answer = {'location': 'outside'}"));
  const std::string engine = std::string("python3 ") + script.path();
  const Json line = reduced_line(called({"reduce", "point_in_polyhedron", question.path(), "--engine", engine.c_str(),
                                         "--timeout", "60", "--jobs", "1", "--out", folder.c_str()}));
  const auto text = [&](const char* name) {
    std::ifstream file(folder / name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  CHECK(parse_own_line(text("question.json")) == line["input"]);
  const std::string asked = (folder / "question.json").string(), mesh = "mesh=" + (folder / "mesh.obj").string();
  const Called again = called({"ask", "point_in_polyhedron", asked.c_str(), "--mesh", mesh.c_str(), "--engine",
                               engine.c_str(), "--timeout", "60"});
  CHECK(again.code == findings);
  CHECK(parse_own_line(again.out)["input"] == line["input"]);
  const std::string claim = (folder / "claim.json").string();
  CHECK(called({"certify", claim.c_str()}).code == nothing_found);
  CHECK_THAT(text("report.md"), ContainsSubstring(one_line(line["input"])) && ContainsSubstring("planted") &&
                                    ContainsSubstring("| touchstone ask point_in_polyhedron --engine") &&
                                    ContainsSubstring("mesh.faces from 72 to 4"));
  for (const char* name : {"test_catch2.cpp", "test_gtest.cpp", "test_pytest.py", "test_jest.test.js"})
    CHECK_THAT(text(name), ContainsSubstring("point_in_polyhedron_1"));
  CHECK_THAT(text("picture.html"), StartsWith("<!DOCTYPE html>") && ContainsSubstring("planted"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("reduce: one line says why there is nothing to reduce") {
  const TextFile right("right.json", R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})"),
      two("two.json", "{\"p0\":[0,0],\"p1\":[1,0],\"p\":[0,1]}\n{\"p0\":[0,0],\"p1\":[1,0],\"p\":[0,1]}\n"),
      empty("empty.json", ""), wrong("wrong.json", R"({"p0":[0,0],"p1":[1,0]})"),
      open("open.json", R"({"mesh":{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[[0,1,2]]},"point":[0,0,0]})");
  require_refused(called({"reduce", "orientation", right.path()}), bad_usage, "nothing to reduce: reference is right");
  require_refused(called({"reduce", "orientation", two.path()}), bad_usage, "line 2: one question, found a second one");
  require_refused(called({"reduce", "orientation", empty.path()}), bad_usage, "one question, found none");
  require_refused(called({"reduce", "orientation", wrong.path()}), bad_usage, "p: missing");
  require_refused(called({"reduce", "point_in_polyhedron", open.path()}), bad_usage, "outside the contract: mesh");
  require_refused(called({"reduce", "orientation", right.path(), "--with", "robust"}), bad_usage, "--with");
  require_refused(called({"reduce", "orientation", right.path(), "--until", "true", "--engine", "true"}), bad_usage,
                  "--engine");
}

TEST_CASE("reduce: complaints are the same whatever numbers they name; exit codes and signals are not") {
  CHECK(reason_of("vertex 12 of 400: no face") == reason_of("vertex 7 of 9: no face"));
  CHECK(reason_of("vertex 12 of 400: no face") != reason_of("vertex 12 of 400: no edge"));
  CHECK(reason_of("exit code 1: out of memory") == reason_of("exit code 1: KeyError: 5"));
  CHECK(reason_of("exit code 1") != reason_of("exit code 2"));
  CHECK(reason_of("signal 6 (Aborted)") != reason_of("signal 11 (Segmentation fault)"));
}

}  // namespace touchstone::proptests::reduce_command_tests
