// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <map>

#include "audit/counting/tally_json.h"
#include "audit/engines/process.h"
#include "catalogue/codec/json.h"
#include "program/engine_main.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// What is done to our own formulas is done to an engine.
namespace touchstone::proptests::with_engine_tests {
namespace {

const char* const engine = "python3 examples/engine.py";

/// Always the same side.
const char* const leftist =
    R"(read greeting; echo '{"engine":"leftist","ops":["orientation"],"boundary":"closed"}'
id=1; while read question; do echo "{\"id\":$id,\"answer\":{\"side\":\"left\"}}"; id=$((id + 1)); done)";

/// Answers in turn what is no answer to any operation.
const char* const malformed = R"(import json, sys

json.loads(sys.stdin.readline())
print(json.dumps({"engine": "malformed", "ops": sys.argv[1].split(",")}), flush=True)
answers = ["0.5", "null", '"hit"', "[]", "[[]]", "true", "[" * 60 + "]" * 60, '{"energy": {}}', '{"no_field": 0}']
for at, line in enumerate(sys.stdin):
    print('{"id": %d, "answer": %s}' % (json.loads(line)["id"], answers[at % len(answers)]), flush=True)
)";

struct MyEngine {
  static constexpr const char* name = "mine 3";
  Side orientation(Point2d, Point2d, Point2d) { return Side::on; }
};

Called called_program(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "bin/mine");
  std::ostringstream out, err;
  auto* const previous_out = std::cout.rdbuf(out.rdbuf());
  auto* const previous_err = std::cerr.rdbuf(err.rdbuf());
  MyEngine mine;
  Called call;
  call.code = engine_program(members_of(mine), static_cast<int>(arguments.size()), arguments.data());
  std::cout.rdbuf(previous_out);
  std::cerr.rdbuf(previous_err);
  call.out = out.str(), call.err = err.str();
  return call;
}

}  // namespace

TEST_CASE("with engine: a regression test of an engine that answers true or false expects that") {
  const TextFile apart("apart.jsonl", R"({"a":{"min":[0,0,0],"max":[1,1,1]},"b":{"min":[0,0,2],"max":[1,1,3]}})"),
      met("met.jsonl", R"({"a":{"min":[0,0,0],"max":[1,1,1]},"b":{"min":[0,0,1],"max":[1,1,3]}})");
  const char* const always_met = R"(read greeting; echo '{"engine":"met","ops":["aabb_aabb"],"boundary":"closed"}'
while read question; do echo "{\"id\":$(echo "$question" | sed 's/.*"id":\([0-9]*\).*/\1/'),\"answer\":true}"; done)";
  for (const auto& [file, expected] : {std::pair{apart.path(), "False"}, std::pair{met.path(), "True"}}) {
    const Called test = called({"ask", "aabb_aabb", file, "--timeout", "60", "--engine", always_met, "--as", "pytest"});
    INFO(test.out << test.err);
    CHECK_THAT(test.out, ContainsSubstring(std::string("expected = ") + expected + "\n"));
  }
  const Called without = called({"ask", "aabb_aabb", met.path(), "--as", "jest"});
  CHECK_THAT(without.out, ContainsSubstring(R"(const expected = {"contact": "touching"};)"));
}

TEST_CASE("with engine: exhaust asks the engine every configuration of the grid") {
  const Called right = called({"exhaust", "orientation", "--grid", "3", "--timeout", "60", "--engine", engine});
  INFO(right.out << right.err);
  CHECK(right.code == nothing_found);  // small whole numbers: no rounding
  CHECK_THAT(right.out, ContainsSubstring("textbook in Python (binary64)") && ContainsSubstring("729"));
  // Of the 3^6 configurations those to the left are right: as many as to the right, and the rest lies on a line.
  const Called wrong =
      called({"exhaust", "orientation", "--grid", "2", "--json", "-", "--timeout", "60", "--engine", leftist});
  CHECK(wrong.code == findings);
  const Json cell = parse_own_line(wrong.out)["operations"][0]["families"][0];
  CHECK(cell["cases"] == 64);
  CHECK(cell["counts"]["agree"] == cell["outcomes"]["left"]);
  CHECK(cell["counts"]["algorithm"].get<int>() + cell["counts"]["rounding"].get<int>() ==
        cell["outcomes"]["right"].get<int>() + cell["outcomes"]["on"].get<int>());
  require_refused(called({"exhaust", "line_line", "--timeout", "60", "--engine", engine}), engine_failed,
                  "it does not declare line_line");
  require_refused(called({"exhaust", "orientation", "--decisions", "--engine", engine}), bad_usage, "--decisions");
}

TEST_CASE("with engine: shards of an engine's exhaustive run merge") {
  const TextFile first("first.json", ""), second("second.json", "");
  called({"exhaust", "orientation", "--grid", "2", "--shard", "1/2", "--json", first.path(), "--engine", leftist});
  called({"exhaust", "orientation", "--grid", "2", "--shard", "2/2", "--json", second.path(), "--engine", leftist});
  const Called merged = called({"merge", first.path(), second.path()});
  const Called whole = called({"exhaust", "orientation", "--grid", "2", "--engine", leftist});
  CHECK(merged.code == findings);
  const auto below_heading = [](const std::string& table) { return table.substr(table.find('\n')); };
  CHECK(below_heading(merged.out) == below_heading(whole.out));
}

TEST_CASE("with engine: an answer that is none costs a verdict, whatever the operation answers, and never the run") {
  const TextFile script("malformed.py", malformed);
  const std::string command = std::string("python3 ") + script.path() + " kinetic_energy,momentum,aabb_of_points";
  const Called checked = called({"check-engine", "--timeout", "60", command.c_str()});
  INFO(checked.out << checked.err);
  CHECK(checked.code == findings);
  CHECK_THAT(checked.out,
             ContainsSubstring("not connected: 3 of 3 operations\n") &&
                 ContainsSubstring(R"(answer: expected an object like {"aabb":{"min":[0,0],"max":[0,0]}}, got 0.5)"));
  const Called audited = called({"audit", "--ops", "kinetic_energy,momentum,aabb_of_points", "--cases", "20",
                                 "--timeout", "60", "--json", "-", "--engine", command.c_str()});
  INFO(audited.err);
  CHECK(audited.code == findings);
  for (const Json& operation : parse_own_line(audited.out)["operations"]) {
    for (const Json& family : operation["families"]) CHECK(family["counts"]["invalid"] == family["cases"]);
  }
}

/// Vectors of some operations, copied to a folder of their own; gone afterwards.
class SomeVectors {
 public:
  explicit SomeVectors(const std::vector<std::string>& operations)
      : folder_(std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_vectors")) {
    std::filesystem::create_directories(folder_);
    for (const std::string& name : operations)
      std::filesystem::copy_file("vectors/" + name + ".jsonl", folder_ / (name + ".jsonl"));
  }
  ~SomeVectors() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  SomeVectors(const SomeVectors&) = delete;
  SomeVectors& operator=(const SomeVectors&) = delete;
  const char* path() const { return folder_.c_str(); }

 private:
  std::filesystem::path folder_;
};

TEST_CASE("with engine: vectors check judges the engine's answers by the oracle, and tells of each wrong one") {
  const SomeVectors folder({"orientation", "aabb_aabb"});
  std::map<std::string, Json> wrong;  // by id: the engine always says left
  std::size_t asked = 0;
  std::ifstream vectors("vectors/orientation.jsonl");
  for (std::string line; std::getline(vectors, line);) {
    const Json vector = parse_own_line(line);
    if (vector.contains("refused")) continue;
    ++asked;
    if (vector["truth"]["side"] != "left") wrong[vector["id"]] = vector;
  }
  const Called call = called({"vectors", "check", folder.path(), "--timeout", "60", "--verbose", "--engine", leftist});
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("leftist: " + std::to_string(asked) + " vectors asked, " +
                                         std::to_string(wrong.size()) + " findings") &&
                           ContainsSubstring(" 0 refused\n") && !ContainsSubstring(" more findings"));
  std::istringstream lines(call.out);
  const auto told = [&](const std::string& key) {
    std::string line;
    std::getline(lines, line);
    CHECK_THAT(line, StartsWith("  " + key + ": "));
    return line.substr(line.find_first_not_of(' ', line.find(':') + 1));
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.find(": line ") == std::string::npos) continue;
    CHECK_THAT(line,
               ContainsSubstring("orientation.jsonl: line ") && (EndsWith(": rounding") || EndsWith(": algorithm")));
    const Json vector = wrong.at(told("vector"));
    wrong.erase(vector["id"].get<std::string>());
    CHECK(parse_own_line(told("input")) == vector["input"]);
    told("hex");
    CHECK(parse_own_line(told("truth")) == vector["truth"]);
    CHECK(told("answer") == R"({"side":"left"})");
    CHECK_THAT(told("repeat"),
               StartsWith("echo '" + one_line(vector["input"]) + "' | touchstone ask orientation --engine ") &&
                   ContainsSubstring("leftist"));
  }
  CHECK(wrong.empty());  // each was told, once
  const Called short_list = called({"vectors", "check", folder.path(), "--timeout", "60", "--engine", leftist});
  CHECK_THAT(short_list.out, ContainsSubstring(" more findings, which --verbose shows\n"));
}

TEST_CASE("with engine: vectors check writes an audit's files, with the ids of the vectors") {
  const SomeVectors folder({"orientation"});
  const TextFile junit("vectors.xml", "");
  const Called call = called({"vectors", "check", folder.path(), "--ops", "orientation", "--timeout", "60", "--json",
                              "-", "--junit", junit.path(), "--engine", leftist});
  INFO(call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.err, ContainsSubstring("leftist: "));  // what people read makes way
  CHECK(tally_json(read_tally(call.out)) == call.out);
  const Json cell = parse_own_line(call.out)["operations"][0]["families"][0];
  const std::string id = cell["ways"][0]["example"]["vector"];
  const auto number = std::stoul(id.substr(id.find('/') + 1));
  CHECK(cell["ways"][0]["example"]["index"] == number);  // the line: in these files they are the same
  std::ifstream vectors("vectors/orientation.jsonl");
  std::string line;
  for (std::size_t at = 0; at < number; ++at) std::getline(vectors, line);
  CHECK(parse_own_line(line)["id"] == id);
  CHECK(parse_own_line(line)["family"] == cell["family"]);
  CHECK(parse_own_line(line)["input"] == cell["ways"][0]["example"]["input"]);
  std::ifstream written(junit.path());
  const std::string xml(std::istreambuf_iterator<char>(written), {});
  CHECK_THAT(xml, ContainsSubstring("<testsuites name=\"touchstone audit of leftist\"") &&
                      ContainsSubstring("vector: orientation/"));
  require_refused(called({"vectors", "check", folder.path(), "--json", "-"}), bad_usage, "--engine");
}

TEST_CASE("with engine: a map shows the engine beside reference and robust") {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_maps");
  const Called call = called({"map", "orientation", "--jobs", "1", "--out", folder.c_str(), "--timeout", "60",
                              "--engine", "python3 proptests/infrastructure/engines/misbehaving.py says_left"});
  INFO(call.out << call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("misbehaving 1 (binary64): "));
  CHECK(std::filesystem::exists(folder / "orientation.png"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("with engine: an engine program's help shows what it has and accepts") {
  const Called help = called_program({"--help"});
  CHECK(help.code == nothing_found);
  for (const char* words : {"mine 3, an engine of touchstone with 1 operation: orientation\n", "bin/mine --serve",
                            "bin/mine [OPTIONS]", "ask OP", "--cases", "--families"})
    CHECK_THAT(help.out, ContainsSubstring(words));
}

TEST_CASE("with engine: an engine program that is started as an engine without --serve says so at once") {
  setenv(started_as_engine, "1", 1);
  const Called call = called_program({"--ops", "orientation"});
  unsetenv(started_as_engine);
  CHECK(call.code == bad_usage);
  CHECK(call.err == "bin/mine: started as an engine without --serve; the command is: bin/mine --serve\n");
  // What an engine is started with, and what becomes of its complaint.
  const std::string without = std::string("test -n \"$") + started_as_engine + "\" && echo without --serve >&2; exit 2";
  require_refused(called({"audit", "--ops", "orientation", "--engine", without.c_str()}), engine_failed,
                  "it said nothing and ended: exit code 2: without --serve");
}

TEST_CASE("with engine: a noisy engine is audited like a quiet one, and its noise is told") {
  const auto audited = [](const std::string& behaviour) {
    const std::string command = "python3 proptests/infrastructure/engines/misbehaving.py " + behaviour;
    return called({"audit", "--ops", "orientation", "--cases", "2000", "--jobs", "1", "--timeout", "60", "--engine",
                   command.c_str()});
  };
  const Called quiet = audited("says_left"), noisy = audited("babbles_and_says_left");
  CHECK(quiet.code == findings);
  CHECK(noisy.code == findings);
  CHECK(quiet.out.substr(0, quiet.out.find("  repeat")) == noisy.out.substr(0, noisy.out.find("  repeat")));
  CHECK_THAT(noisy.err,
             ContainsSubstring("lines of its standard output that are no answer, the last: have a nice day") &&
                 !ContainsSubstring("restarted"));
}

}  // namespace touchstone::proptests::with_engine_tests
