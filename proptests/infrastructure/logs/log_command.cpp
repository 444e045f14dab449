// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "proptests/catch.h"
#include "proptests/infrastructure/program/called.h"

namespace touchstone::proptests::log_command_tests {
namespace {

const std::string header = R"({"touchstone_log":1,"engine":"game"})"
                           "\n";
const std::string on =
    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[2,0]},"answer":{"side":"on"},"site":"a.c:1"})"
    "\n";
const std::string crossing =
    R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,-1],[1,1]]},"answer":{"relation":"point","ta":0.5,"point":[1,0]}})"
    "\n";
const std::string no_operation = R"({"op":"orientatoin","input":{},"answer":true})"
                                 "\n";
const std::string end = R"({"end":{"seen":5,"written":1,"sampled_out":3,"lost":1}})"
                        "\n";

TEST_CASE("log: show says what a log holds, what became of the other calls, and what no operation takes") {
  const TextFile log("shown", header + on + no_operation + end);
  const Called shown = called({"log", "show", log.path()});
  REQUIRE(shown.code == 0);
  REQUIRE(shown.out ==
          std::string(log.path()) +
              ": JSON lines, version 1, recorded from game\n"
              "5 calls seen: 1 written, 3 left out by sampling, 1 lost because the file was full or could not be "
              "written\n"
              "operation    site   calls  numbers   answers\n"
              "orientation  a.c:1      1  binary64  whole\n"
              "1 call that no operation takes: orientatoin: no operation of the catalogue (did you mean "
              "\"orientation\"?); the first: " +
              log.path() + ":3: op: orientatoin: no operation of the catalogue (did you mean \"orientation\"?)\n");
}

TEST_CASE("log: convert writes the other form, and the same form where it is named") {
  const TextFile log("lines", header + on + crossing + end), binary("binary", ""), again("again", "");
  REQUIRE(called({"log", "convert", log.path(), binary.path()}).code == 0);
  REQUIRE(called({"log", "convert", binary.path(), "-"}).out == header + on + crossing + end);
  REQUIRE(called({"log", "convert", binary.path(), "-", "--to", "json"}).out == header + on + crossing + end);
  REQUIRE(called({"log", "convert", binary.path(), again.path(), "--to", "binary"}).code == 0);
  REQUIRE(called({"log", "convert", again.path(), "-"}).out == header + on + crossing + end);
  const TextFile cut("cut", header + on + crossing);
  REQUIRE(called({"log", "convert", cut.path(), "-", "--to", "json"}).out == header + on + crossing);
}

TEST_CASE("log: convert says which calls it leaves out, with exit code 2") {
  const TextFile log("refused", no_operation + on);
  const Called converted = called({"log", "convert", log.path(), "-", "--to", "json"});
  REQUIRE(converted.code == 2);
  REQUIRE(converted.out == on);
  REQUIRE_THAT(converted.err, StartsWith("1 call that no operation takes: orientatoin"));
}

TEST_CASE("log: what cannot be read or written is one line, with exit code 2") {
  const TextFile log("log", header + on + end), two("two", header + on + end + header + on + end);
  require_refused(called({"log", "show", "no such log"}), 2, "no such log: no such file or directory");
  require_refused(called({"log", "show", "proptests"}), 2, "proptests: is a directory");
  require_refused(called({"log", "convert", log.path(), log.path()}), 2, "is the log that is read");
  require_refused(called({"log", "convert", log.path(), "no such folder/out"}), 2,
                  "no such folder/out: cannot be written");
  require_refused(called({"log", "convert", two.path(), "-"}), 2, "several logs");
}

TEST_CASE("log: where the program is missing that decompresses a log, it is named") {
  const TextFile packed("packed", "\x1f\x8b\x08 and so on");
  const char* const path = std::getenv("PATH");
  const std::string before = path != nullptr ? path : "";
  setenv("PATH", "/nowhere", 1);
  const Called shown = called({"log", "show", packed.path()});
  setenv("PATH", before.c_str(), 1);
  require_refused(shown, 2, "compressed by gzip, and there is no program gzip to read it");
}

}  // namespace
}  // namespace touchstone::proptests::log_command_tests
