// SPDX-License-Identifier: Apache-2.0
#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// The program as it is called: exit codes, and one line on standard error where it refuses.
namespace touchstone::proptests::program_tests {

TEST_CASE("program: numbers that an option cannot hold are refused in one line") {
  for (const char* cases : {"0", "-1", "1.5", "1e6", "99999999999999999999", "x"}) {
    require_refused(called({"audit", "--cases", cases}), bad_usage, "an integer from 1 to");
  }
  for (const char* seed : {"-1", "18446744073709551616", "one"}) {
    require_refused(called({"audit", "--seed", seed}), bad_usage, "an integer from 0 to 18446744073709551615");
  }
}

TEST_CASE("program: a command that is none is named, with those that are") {
  require_refused(called({"adit"}), bad_usage, "adit: no command (did you mean \"audit\"?); one of ops, ask, audit");
}

TEST_CASE("program: a mesh from a file is the field of every line, and a file that cannot be read is named") {
  const auto folder = std::filesystem::temp_directory_path() / ("touchstone_mesh_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string lines = (folder / "lines.jsonl").string(), given = "mesh=" + (folder / "solid.off").string();
  std::ofstream(lines) << "{\"point\":[1,1,1]}\n{\"point\":[9,0,0]}\n";
  std::ofstream(folder / "solid.off") << "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const Called asked = called({"ask", "point_in_convex_polyhedron", "--mesh", given.c_str(), lines.c_str()});
  INFO(asked.err);
  CHECK(asked.code == nothing_found);
  CHECK_THAT(asked.out, ContainsSubstring("\"truth\":{\"location\":\"inside\"}") &&
                            ContainsSubstring("\"truth\":{\"location\":\"outside\"}"));
  require_refused(called({"ask", "point_in_convex_polyhedron", "--mesh", "mesh=/nowhere/solid.off", lines.c_str()}),
                  bad_usage, "/nowhere/solid.off: cannot be read: no such file");
  require_refused(called({"ask", "point_in_convex_polyhedron", "--mesh", "solid.off", lines.c_str()}), bad_usage,
                  "solid.off: cannot be read: no such file");
  require_refused(called({"ask", "point_in_convex_polyhedron", "--mesh", given.c_str(), "--mesh", given.c_str()}),
                  bad_usage, "--mesh: mesh is given twice");
  require_refused(called({"ask", "point_in_convex_polyhedron", "--mesh", "=solid.off", lines.c_str()}), bad_usage,
                  "--mesh: expected field=FILE with field mesh, got =solid.off");
  std::filesystem::remove_all(folder);
}

TEST_CASE("program: an operation named twice is asked once") {
  CHECK(operations_named("orientation,explicit_line,orientation").size() == 2);
}

TEST_CASE("program: an engine that has none of the operations asked is an engine that cannot be run") {
  const char* const engine = R"(echo '{"engine":"e 1","ops":["juggle"]}'; cat)";
  require_refused(called({"audit", "--ops", "orientation,line_line", "--cases", "10", "--engine", engine}),
                  engine_failed, "e 1: it declares none of the operations asked: orientation, line_line");
}

TEST_CASE("program: what cannot be written is known before the first question, by its option") {
  require_refused(called({"audit", "--json", "/no/such/folder/file"}), bad_usage, "--json /no/such/folder/file");
  require_refused(called({"audit", "--report", "/dev/null/report"}), bad_usage, "--report /dev/null/report");
  require_refused(called({"audit", "--report-seconds", "5"}), bad_usage, "expected --report too");
  require_refused(called({"exhaust", "orientation", "--json", "/no/such/folder/file"}), bad_usage, "--json /no/such");
}

TEST_CASE("program: nothing judged is not nothing found") {
  require_refused(called({"exhaust", "line_line", "--grid", "1"}), bad_usage, "nothing was judged");
  const char* const engine = R"(echo '{"engine":"e 1","ops":["orientation"]}'; read greeting; id=1
while read question; do echo "{\"id\":$id,\"unsupported\":true}"; id=$((id + 1)); done)";
  const std::vector<const char*> audit{"audit",  "--ops", "orientation", "--cases", "40",
                                       "--jobs", "1",     "--engine",    engine};
  for (const char* gate : {"", "--fail-on=algorithm"}) {
    std::vector<const char*> words = audit;
    if (*gate != 0) words.push_back(gate);
    const Called call = called(words);
    CHECK(call.code == bad_usage);
    CHECK_THAT(call.err, ContainsSubstring("nothing was judged: the engine says of every question"));
  }
}

TEST_CASE("program: a number that is none costs an engine its question and not the run") {
  const std::string script =
      (std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_engine.sh")).string();
  std::ofstream(script) << R"(echo '{"engine":"e 1","ops":["line_point_at"]}'
read greeting
id=1
while read question; do echo "{\"id\":$id,\"answer\":{\"point\":[0x10,1]}}"; id=$((id + 1)); done
)";
  const std::string command = "sh " + script;
  const Called call =
      called({"audit", "--ops", "line_point_at", "--cases", "40", "--jobs", "1", "--engine", command.c_str()});
  std::filesystem::remove(script);
  INFO(call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("answer.point[0]: expected a number, got 0x10") &&
                           ContainsSubstring(R"({"point":["0x10",1]})"));
}

TEST_CASE("program: ask puts a question to an engine as well, and judges its answer") {
  const std::string name = (std::filesystem::temp_directory_path() / std::to_string(::getpid())).string() + "_ask";
  std::ofstream(name) << R"({"a":[[0,0],[2,0]],"b":[[3,0],[4,0]]})"
                         "\n"
                         R"({"a":[[0,0],[2,2]],"b":[[0,2],[2,0]]})"
                         "\n";
  const char* const python = "python3 examples/engine.py";
  const Called call = called({"ask", "segment_segment", name.c_str(), "--engine", python});
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  const std::size_t second = call.out.find('\n') + 1;
  CHECK_THAT(call.out.substr(0, second),
             ContainsSubstring(
                 R"("engine":{"name":"textbook in Python","answer":true,"verdict":"wrong","cause":"algorithm"})"));
  CHECK_THAT(call.out.substr(second),
             ContainsSubstring(R"("engine":{"name":"textbook in Python","answer":true,"verdict":"agree"})"));
  CHECK(called({"ask", "segment_segment", name.c_str()}).out.find("\"engine\"") == std::string::npos);
  std::filesystem::remove(name);
  require_refused(called({"ask", "line_line", "--engine", python}), engine_failed,
                  "textbook in Python: it does not declare line_line");
  require_refused(called({"ask", "line_line", "--engine", "exit 3"}), engine_failed, "exit code 3");
}

TEST_CASE("program: an engine in float is asked about the floats nearest to the numbers of the line") {
  const std::string name = (std::filesystem::temp_directory_path() / std::to_string(::getpid())).string() + "_float";
  std::ofstream(name) << R"({"slope":0.1,"intercept":0,"point":[1,0.1]})"
                         "\n";
  const char* const engine =
      R"(read greeting; echo '{"engine":"e","ops":["explicit_line"],"number":"binary32"}'; read question
    case "$question" in *0.10000000149011612*) side=on;; *) side=above;; esac
    echo "{\"id\":1,\"answer\":{\"side\":\"$side\"}}")";
  const Called call = called({"ask", "explicit_line", name.c_str(), "--engine", engine});
  std::filesystem::remove(name);
  INFO(call.err);
  CHECK_THAT(call.out, ContainsSubstring(R"("answer":{"side":"on"},"verdict":"agree")"));
  CHECK_THAT(call.out, ContainsSubstring(R"("input":{"slope":0.10000000149011612)"));
}

TEST_CASE("program: asking an engine one question ends with 1 where its answer is a finding") {
  const TextFile on_line("on_line.jsonl", R"({"p0":[0,0],"p1":[2,2],"p":[1,1]})"),
      lost("lost.jsonl", R"({"p0":[0,0],"p1":[134217729,134217728],"p":[134217728,134217727]})");
  const char* const engine = "python3 examples/engine.py";
  CHECK(called({"ask", "orientation", "--engine", engine, on_line.path()}).code == nothing_found);
  CHECK(called({"ask", "orientation", "--engine", engine, lost.path()}).code == findings);
}

}  // namespace touchstone::proptests::program_tests
