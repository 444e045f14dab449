// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "audit/counting/easy_questions.h"
#include "audit/engines/protocol.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

namespace touchstone::proptests::check_engine_tests {
namespace {

/// Answers orientation and segment_segment rightly, or connected as its argument says.
const char* const connected = R"(import json, sys

def cross(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

def orientation(p0, p1, p):
    s = cross(p0, p1, p)
    return "left" if s > 0 else "right" if s < 0 else "on"

connections = {
    "rightly": lambda side: {"side": side},
    "sign": lambda side: {"side": {"left": "right", "right": "left", "on": "on"}[side]},
    "field": lambda side: {"sid": side},
    "word": lambda side: {"side": side.upper()},
    "bare": lambda side: side,
    "always": lambda side: {"side": "left"},
    "bug": lambda side: {"side": "on" if side == "right" else side},
}
sys.stdin.readline()
print(json.dumps({"engine": "small 1", "ops": sys.argv[2].split(","), "boundary": "closed"}), flush=True)
for line in sys.stdin:
    q = json.loads(line, parse_int=float)
    if sys.argv[1] == "declines" or (sys.argv[1] == "in_space" and len(q["input"]["a"]["min"]) == 2):
        print(json.dumps({"id": q["id"], "unsupported": True}), flush=True)
        continue
    asked = q["op"] == "orientation" and sys.argv[1] != "in_space"
    said = connections[sys.argv[1]](orientation(**q["input"])) if asked else True
    print(json.dumps({"id": q["id"], "answer": said}), flush=True)
)";

/// Six times the volume of the first mesh of a question. The words are the numbers of its vertices and faces, and the
/// faces.
double signed_volume(const std::vector<double>& numbers, const std::vector<Word>& words) {
  const auto at = [&](Word vertex, int axis) { return numbers[3 * vertex + axis] - numbers[axis]; };
  double sum = 0;
  for (Word f = 0; f < words[1]; ++f) {
    const Word a = words[2 + 3 * f], b = words[3 + 3 * f], c = words[4 + 3 * f];
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      sum += at(a, k) * (at(b, l) * at(c, m) - at(b, m) * at(c, l));
    }
  }
  return sum;
}

Called checked(const std::string& connection, const std::string& operations = "orientation") {
  const TextFile engine("connected.py", connected);
  const std::string command = std::string("python3 ") + engine.path() + " " + connection + " " + operations;
  return called({"check-engine", "--timeout", "60", command.c_str()});
}

}  // namespace

TEST_CASE("check-engine: an engine that is connected correctly passes") {
  const Called call = checked("rightly");
  INFO(call.out << call.err);
  CHECK(call.code == nothing_found);
  CHECK_THAT(call.out, StartsWith("small 1 (binary64), boundary closed, tolerance 0\n") &&
                           ContainsSubstring("5 of 5 right") && ContainsSubstring("connected: 1 operation\n"));
  CHECK(call.err.empty());
}

TEST_CASE("check-engine: an operation of which no easy question is supported is not called connected") {
  const Called call = checked("declines");
  CHECK(call.code == findings);
  CHECK_THAT(call.out,
             ContainsSubstring("connected: 0 operations\nnot checked: 1 operation, of which no easy question"));
}

TEST_CASE("check-engine: boxes in the plane are asked, and boxes in space") {
  const Called call = checked("in_space", "aabb_aabb");
  INFO(call.out << call.err);
  CHECK_THAT(call.out, ContainsSubstring(" not supported\n") && !ContainsSubstring("5 not supported\n"));
}

TEST_CASE("check-engine: what is connected wrongly is said as expectation and fact") {
  const auto require_told = [](const std::string& connection, const std::string& words) {
    const Called call = checked(connection);
    INFO(call.out << call.err);
    CHECK(call.code == findings);
    CHECK_THAT(call.out, ContainsSubstring(words) && ContainsSubstring("not connected: 1 of 1 operation\n"));
  };
  require_told("field", "answer.sid: no such field (did you mean \"side\"?); expected side\n");
  require_told("word", "answer.side: expected one of left, on, right, got \"");
  require_told("bare", R"(answer: expected an object like {"side":"left"}, got ")");
  require_told("sign",
               "right is said for left, left is said for right: is the order of the arguments, or a sign, another");
  require_told("always", "another answer than the definition gives");
}

TEST_CASE("check-engine: an engine with a bug is connected, and is said to be wrong") {
  const Called call = checked("bug");
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("\nconnected: 1 operation\nconnected, and wrong at an easy question: 1 op"));
}

TEST_CASE("check-engine: an engine of which only the numbers are off is connected") {
  const TextFile engine("doubled.py", R"(import json, sys
sys.stdin.readline()
print(json.dumps({"engine": "doubled", "ops": ["line_point_at"]}), flush=True)
for line in sys.stdin:
    q = json.loads(line, parse_int=float)
    l, t = q["input"]["line"], q["input"]["t"]
    point = [o + 2 * t * d for o, d in zip(l["origin"], l["direction"])]
    print(json.dumps({"id": q["id"], "answer": {"point": point}}), flush=True)
)");
  const std::string command = std::string("python3 ") + engine.path();
  const Called call = called({"check-engine", "--timeout", "60", command.c_str()});
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out,
             ContainsSubstring("0 of 5 right") && ContainsSubstring("a number is off: ") &&
                 ContainsSubstring("\nconnected: 1 operation\nconnected, and wrong at an easy question: 1 op"));
}

TEST_CASE("check-engine: every operation is told apart, and a name misspelt is told with the one meant") {
  const Called call = checked("rightly", "orientation,segment_segment,ray_segmnt");
  INFO(call.out << call.err);
  CHECK(call.code == findings);  // the truth is not always that segments meet
  CHECK_THAT(call.out, ContainsSubstring("not connected: 1 of 2 operations\n"));
  CHECK_THAT(call.err, ContainsSubstring("ray_segmnt: no operation of the catalogue (did you mean \"ray_segment\"?)"));
}

TEST_CASE("check-engine: an engine that does not start, or has no operation, cannot be run") {
  require_refused(called({"check-engine", "exit 3"}), engine_failed, "exit code 3");
  require_refused(called({"check-engine", "echo '{\"engine\":\"e\",\"ops\":[\"juggle\"]}'; cat"}), engine_failed,
                  "it declares none of the operations; ops: juggle: no operation of the catalogue, never asked");
  require_refused(called({"check-engine", ""}), bad_usage, "expected the command of an engine, got an empty one");
}

TEST_CASE("check-engine: a method of an operation is not offered, and an engine that has it alone is told so") {
  const std::string method = "polygon_convexity_interior_angles";
  const std::string why = method + ": a method of polygon_convexity, which engines are asked instead";
  const Json offered = parse_own_line(greeting())["ops"];
  for (const Operation* operation : all_operations()) {
    INFO(operation->name());
    CHECK(std::count(offered.begin(), offered.end(), operation->name()) ==
          (operation->metadata().is_implementation() ? 0 : 1));
  }
  const std::string alone = "echo '{\"engine\":\"e\",\"ops\":[\"" + method + "\"]}'; cat";
  const std::string none = "it declares none of the operations";
  require_refused(called({"check-engine", alone.c_str()}), engine_failed, none + "; ops: " + why);
  const Called audited = called({"audit", "--cases", "1", "--engine", alone.c_str()});
  require_refused(audited, engine_failed, none + " asked: explicit_line, ");
  CHECK_THAT(audited.err, ContainsSubstring("; ops: " + why));
  for (const char* command : {"exhaust", "map", "ask"})
    require_refused(called({command, method.c_str(), "--engine", alone.c_str()}), bad_usage, "--engine: " + why);
  require_refused(called({"audit", "--ops", method.c_str(), "--engine", alone.c_str()}), bad_usage, "--engine: " + why);
}

TEST_CASE("check-engine: every operation has five easy questions, or as many as it has, and robust answers them") {
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    const auto easy = easy_questions(*operation);
    INFO(operation->name());
    CHECK(easy.size() == 5);
    std::set<std::string> asked;
    for (const EasyQuestion& one : easy) {
      CHECK_FALSE(one.examination->touch());
      CHECK(one.examination->judge_robust().verdict == Verdict::agree);
      asked.insert(one_line(operation->print(one.question)));
    }
    CHECK(asked.size() == easy.size());
  }
  for (const char* of_meshes : {"point_in_convex_polyhedron", "point_in_polyhedron", "swept_convex_polyhedra"})
    for (const EasyQuestion& one : easy_questions(*find_operation(of_meshes)))
      CHECK(signed_volume(one.question.numbers, one.question.words) > 0);
  const auto sides = easy_questions(*find_operation("orientation"));
  std::set<std::string> truths;
  for (const EasyQuestion& one : sides) truths.insert(one.examination->outcome());
  CHECK(truths == std::set<std::string>{"left", "right"});  // "on" is a touch
}

}  // namespace touchstone::proptests::check_engine_tests
