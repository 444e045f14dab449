// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/progress.h"

#include <sstream>

#include "proptests/catch.h"
#include "proptests/uses.h"

/// The clock of these tests is a number.
namespace touchstone::proptests::progress_tests {
namespace {

using std::chrono::milliseconds;

/// Two operations of cost 1 and one of cost 3: shares of a fifth, a fifth and three fifths.
std::vector<const Operation*> operations() {
  return {find_operation("orientation"), find_operation("line_line"), find_operation("polygon_convexity")};
}

struct Reported {
  std::ostringstream err;
  Progress::Clock::time_point now{};
  Progress progress;
  Reported() : progress(err, false, operations(), 1000, [this] { return now; }) {}
};

}  // namespace

TEST_CASE("progress: a log gets a line every ten seconds, with the whole and the time left") {
  REQUIRE(operations()[2]->metadata().cost == 3);
  Reported reported;
  reported.progress("orientation", 500);
  reported.now += milliseconds(9'999);
  reported.progress("orientation", 800);
  CHECK(reported.err.str().empty());
  reported.now += milliseconds(1);
  reported.progress("orientation", 1000);  // a fifth in 10 s, so four fifths in 40
  CHECK(reported.err.str() == "touchstone: 20 %, orientation (1 of 3), about 40 s left\n");
  reported.now += milliseconds(9'999);
  reported.progress("line_line", 1000);
  reported.now += milliseconds(20'001);
  reported.progress("polygon_convexity", 500);  // seven tenths in 40 s
  CHECK(reported.err.str() ==
        "touchstone: 20 %, orientation (1 of 3), about 40 s left\n"
        "touchstone: 70 %, polygon_convexity (3 of 3), about 17 s left\n");
}

TEST_CASE("progress: a terminal gets one line, which is gone at the end") {
  std::ostringstream err;
  Progress::Clock::time_point now{};
  {
    Progress progress(err, true, operations(), 1000, [&] { return now; });
    now += milliseconds(100);
    progress("orientation", 500);
    progress("orientation", 600);  // too soon
    CHECK(err.str() == "\r\x1b[K10 %, orientation (1 of 3)");
  }
  CHECK(err.str() == "\r\x1b[K10 %, orientation (1 of 3)\r\x1b[K");
}

TEST_CASE("progress: what an engine does not have is no part of the whole") {
  Reported reported;
  reported.progress.leave_out([](const Operation& operation) { return operation.name() == "polygon_convexity"; });
  reported.now += milliseconds(10'000);
  reported.progress("line_line", 0);
  CHECK(reported.err.str() == "touchstone: 50 %, line_line (2 of 2), about 10 s left\n");
}

TEST_CASE("progress: nothing is written of a run that is shorter than ten seconds, on no terminal") {
  std::ostringstream err;
  {
    Progress progress(err, false, operations(), 10);
    progress("orientation", 10);
  }
  CHECK(err.str().empty());
}

TEST_CASE("progress: once the cases are asked, it says how many findings are made smaller") {
  Reported reported;
  reported.now += milliseconds(10'000);
  reported.progress.smaller("line_line", 3, 12);
  reported.progress.smaller("polygon_convexity", 1, 1);  // too soon
  reported.now += milliseconds(10'000);
  reported.progress.smaller("polygon_convexity", 1, 1);
  CHECK(reported.err.str() ==
        "touchstone: 40 %, line_line (2 of 3), making 12 findings smaller: 3 of 12\n"
        "touchstone: 100 %, polygon_convexity (3 of 3), making 1 finding smaller: 1 of 1\n");
}

TEST_CASE("progress: times are told as people tell them") {
  using Seconds = std::chrono::duration<double>;
  CHECK(in_words(Seconds(0.2)) == "1 s");
  CHECK(in_words(Seconds(89)) == "89 s");
  CHECK(in_words(Seconds(600)) == "10 min");
  CHECK(in_words(Seconds(3 * 3600)) == "3 h");
}

TEST_CASE("progress: the pages of a report follow, and are gone at the end too") {
  std::ostringstream err;
  Progress::Clock::time_point now{};
  Progress progress(err, true, operations(), 1000, [&] { return now; });
  progress.end();
  CHECK(err.str().empty());
  now += milliseconds(100);
  progress.step("report", "orientation", 0, 3);
  CHECK(err.str() == "\r\x1b[Kreport: 0 of 3, orientation");
  progress.end();
  CHECK(err.str() == "\r\x1b[Kreport: 0 of 3, orientation\r\x1b[K");
}

}  // namespace touchstone::proptests::progress_tests
