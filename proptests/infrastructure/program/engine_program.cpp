// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "audit/engines/process.h"
#include "program/engine_main.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// The program that a C++ engine becomes.
namespace touchstone::proptests::engine_program_tests {
namespace {

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

TEST_CASE("engine program: its help shows what it has and accepts") {
  const Called help = called_program({"--help"});
  CHECK(help.code == nothing_found);
  for (const char* words : {"mine 3, an engine of touchstone with 1 operation: orientation\n", "bin/mine --serve",
                            "bin/mine [OPTIONS]", "ask OP", "--cases", "--families"})
    CHECK_THAT(help.out, ContainsSubstring(words));
}

TEST_CASE("engine program: one that is started as an engine without --serve says so at once") {
  setenv(started_as_engine, "1", 1);
  const Called call = called_program({"--ops", "orientation"});
  unsetenv(started_as_engine);
  CHECK(call.code == bad_usage);
  CHECK(call.err == "bin/mine: started as an engine without --serve; the command is: bin/mine --serve\n");
}

}  // namespace touchstone::proptests::engine_program_tests
