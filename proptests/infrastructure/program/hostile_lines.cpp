// SPDX-License-Identifier: Apache-2.0
#include "program/commands/commands.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// Lines that nobody writes by accident cost themselves, with one line of complaint, and nothing else.
namespace touchstone::proptests::hostile_lines_tests {
namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

const std::string good = R"({"a":[[0,0],[2,0]],"b":[[3,0],[4,0]]})";
const std::string deep = "{\"a\":" + nested(100'000) + ",\"b\":[[3,0],[4,0]]}";

}  // namespace

TEST_CASE("program: a line nested 100,000 deep costs ask that line, with one error, and the next is answered") {
  const TextFile lines("deep.jsonl", deep + "\n" + good + "\n");
  const Called call = called({"ask", "segment_segment", lines.path()});
  require_refused(call, bad_usage, "line 1: line: nested at most 64 deep");
  CHECK_THAT(call.out, StartsWith(R"({"error":{"field":"line","rule":"nested at most 64 deep"}})") &&
                           ContainsSubstring(R"("truth":{"relation":"disjoint"})"));
}

TEST_CASE("program: a result nested 100,000 deep is refused by merge, and a claim by certify") {
  const TextFile line("deep.json", deep + "\n");
  require_refused(called({"merge", line.path()}), bad_usage, "line 1: line: nested at most 64 deep");
  const Called certified = called({"certify", line.path()});
  require_refused(certified, findings, "line 1: claim: nested at most 64 deep");
  CHECK(certified.out == "1 certificates, 1 refused\n");
}

TEST_CASE("program: an object of 100,000 fields is refused at the 1,001st") {
  std::string fields;
  for (int i = 0; i < 100'000; ++i) fields += (i == 0 ? "{\"k" : ",\"k") + std::to_string(i) + "\":0";
  const TextFile lines("fields.jsonl", fields + "}\n" + good + "\n");
  const Called call = called({"ask", "segment_segment", lines.path()});
  require_refused(call, bad_usage, "line 1: line: at most 1000 fields in an object");
}

TEST_CASE("program: a vector nested 100,000 deep is complained about, and the others are checked") {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_deep_vectors");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "x.jsonl") << deep << "\nnonsense\n";
  const Called call = called({"vectors", "check", folder.c_str()});
  std::filesystem::remove_all(folder);
  CHECK(call.code == findings);
  CHECK_THAT(call.err, ContainsSubstring("line 1: line: nested at most 64 deep\n") &&
                           EndsWith("line 2: line: one JSON object\n"));
  CHECK(call.out == "2 vectors, 2 refused\n");
}

TEST_CASE("program: an object without fields, where one of several is meant, is told what each begins with") {
  const TextFile line("commands.jsonl", R"({"boxes":[],"commands":[{}]})"
                                        "\n");
  require_refused(called({"ask", "broad_phase", line.path()}), bad_usage,
                  "commands[0]: expected an object with one of insert, move, remove, ask, in_box, at_point, along_ray, "
                  "got {}");
}

TEST_CASE("program: a key of a line is shown without control characters, and of a long one the beginning") {
  const TextFile escape("escape.jsonl", "{\"\\u001b[2J\\u0000\\u009b\":1}\n{\"a\":{\"\\u0007\":1,\"\\u0007\":2}}\n");
  const Called escaped = called({"ask", "segment_segment", escape.path()});
  CHECK_THAT(escaped.err, ContainsSubstring("line 1: \\x1b[2J\\x00\\xc2\\x9b: no such field; expected a, b") &&
                              ContainsSubstring("line 2: \\x07: given once"));
  const TextFile long_key("key.jsonl", "{\"" + std::string(20'000'000, 'k') + "\":1}\n");
  const Called cut = called({"ask", "segment_segment", long_key.path()});
  require_refused(cut, bad_usage,
                  "line 1: " + std::string(60, 'k') + "... (20000000 bytes): no such field; expected a, b");
  CHECK(cut.out.size() < 200);
  require_refused(called({"merge", long_key.path()}), bad_usage, "touchstone: missing");
}

TEST_CASE("program: names in a result that is merged, and in arguments, are shown without control characters") {
  const TextFile result("result.json", "");
  REQUIRE(called({"audit", "--ops", "orientation", "--cases", "10", "--jobs", "1", "--json", result.path()}).code <= 1);
  std::stringstream text;
  text << std::ifstream(result.path()).rdbuf();
  std::string changed = text.str();
  changed.replace(changed.find("\"reference\""), 11, "\"\\u001b[2J" + std::string(100'000, 'e') + "\"");
  const TextFile named("named.json", changed);
  const Called merged = called({"merge", named.path()});
  INFO(merged.err);
  CHECK(merged.code <= findings);
  CHECK_THAT(merged.out, ContainsSubstring("\\x1b[2Jee") && !ContainsSubstring("\x1b"));
  CHECK(merged.out.size() < 20'000);
  require_refused(called({"ask", "orientation", "\x1b[2J"}), bad_usage, "\\x1b[2J: cannot be read: no such file");
}

TEST_CASE("program: what cannot be written to standard output is a failure, not a success") {
  const TextFile lines("lines.jsonl", good + "\n");
  std::ostringstream err;
  auto* const previous_out = std::cout.rdbuf(nullptr);
  auto* const previous_err = std::cerr.rdbuf(err.rdbuf());
  const char* const arguments[] = {"touchstone", "ask", "segment_segment", lines.path()};
  const int code = run_program(4, arguments);
  std::cout.rdbuf(previous_out);
  std::cerr.rdbuf(previous_err);
  require_refused({code, "", err.str()}, bad_usage, "standard output: cannot be written");
}

TEST_CASE(
    "program: an engine that answers 800,000 bytes is not asked on to shrink its findings, nor quoted at length") {
  const TextFile asked("asked.txt", "");
  const TextFile script("long.py", R"(import json, sys
sys.stdin.readline()
print('{"engine":"e 1","ops":["orientation"]}', flush=True)
for line in sys.stdin:
    open(sys.argv[1], "a").write(line)
    print('{"id":%d,"answer":{"side":"left","why":"%s"}}' % (json.loads(line)["id"], "x" * 800000), flush=True)
)");
  const std::string command = std::string("python3 ") + script.path() + " " + asked.path();
  const Called call =
      called({"audit", "--ops", "orientation", "--cases", "3", "--jobs", "1", "--engine", command.c_str()});
  INFO(call.err);
  CHECK(call.code == findings);
  CHECK_THAT(call.out, ContainsSubstring("xxx... (800024 bytes)"));
  CHECK(call.out.size() < 3 * 10'000);
  std::ifstream questions(asked.path());
  // Three, and for each of at most three findings two until a mebibyte is full and two that look at what was found.
  CHECK(std::count(std::istreambuf_iterator<char>(questions), {}, '\n') <= 3 + 3 * 4);
}

}  // namespace touchstone::proptests::hostile_lines_tests
