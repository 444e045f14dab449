// SPDX-License-Identifier: Apache-2.0
#include "program/commands.h"
#include "proptests/machine/program/called.h"

/// Lines that nobody writes by accident cost themselves, with one line of complaint, and nothing else.
namespace touchstone::audit {
namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

const std::string good = R"({"a":[[0,0],[2,0]],"b":[[3,0],[4,0]]})";
const std::string deep = "{\"a\":" + nested(100'000) + ",\"b\":[[3,0],[4,0]]}";

}  // namespace

TEST_CASE("program: a line nested 100,000 deep costs ask that line, with one error, and the next is answered") {
  const TextFile lines("deep.jsonl", deep + "\n" + good + "\n");
  const Called call = called({"ask", "segment_segment", lines.path()});
  require_refused(call, bad_usage, "line 1: line: nested at most 64 deep");
  CHECK_THAT(call.out, Catch::StartsWith(R"({"error":{"field":"line","rule":"nested at most 64 deep"}})") &&
                           Catch::Contains(R"("truth":{"relation":"disjoint"})"));
}

TEST_CASE("program: a result nested 100,000 deep is refused by merge, and a claim by certify") {
  const TextFile line("deep.json", deep + "\n");
  require_refused(called({"merge", line.path()}), bad_usage, "line 1: line: nested at most 64 deep");
  const Called certified = called({"certify", line.path()});
  require_refused(certified, findings, "line 1: claim: nested at most 64 deep");
  CHECK(certified.out == "1 certificates, 1 refused\n");
}

TEST_CASE("program: a vector nested 100,000 deep is complained about, and the others are checked") {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_deep_vectors");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "x.jsonl") << deep << "\nnonsense\n";
  const Called call = called({"vectors", "check", folder.c_str()});
  std::filesystem::remove_all(folder);
  CHECK(call.code == findings);
  CHECK_THAT(call.err, Catch::Contains("line 1: line: nested at most 64 deep\n") &&
                           Catch::EndsWith("line 2: line: one JSON object\n"));
  CHECK(call.out == "2 vectors, 2 refused\n");
}

}  // namespace touchstone::audit
