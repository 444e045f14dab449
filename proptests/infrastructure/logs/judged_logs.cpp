// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/tally_json.h"
#include "audit/judging/judge_logs.h"
#include "audit/vectors/from_logs.h"
#include "proptests/infrastructure/program/called.h"
#include "report/pages/html_nearness.h"
#include "report/screen/recorded.h"
#include "report/words/wording.h"

/// Logs of a few calls, of which every count is known by hand.
namespace touchstone::proptests::judged_logs_tests {
namespace {

using namespace audit;

const std::string left = R"({"op":"orientation","input":{"p0":[0,0],"p1":[2,1],"p":[0,5]},"answer":{"side":"left"}})"
                         "\n";
/// b ends on a: the convention where sets are open, wrong where they are closed.
const std::string touch = R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,0],[1,1]]},"answer":false})"
                          "\n";
/// a and b are 2^-10 apart.
const std::string apart =
    R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,0.0009765625],[1,1]]},"answer":true})"
    "\n";
/// They meet at a third of a, which float rounds to 0.3333333432674408.
const std::string third_in_float =
    R"({"op":"segment_segment","input":{"a":[[0,0],[3,0]],"b":[[1,-1],[1,1]]},"answer":)"
    R"({"relation":"point","ta":0.3333333432674408,"tb":0.5,"point":[1,0]},"number":"binary32"})"
    "\n";

std::string header(const std::string& fields) { return R"({"touchstone_log":1,)" + fields + "}\n"; }

JudgedLogs judged(const std::vector<std::string>& logs, JudgeOptions options = {}) {
  std::deque<TextFile> files;
  for (const std::string& log : logs)
    options.files.emplace_back(files.emplace_back(std::to_string(files.size()), log).path());
  if (options.operations.empty()) options.operations = all_operations();
  return judge_logs(options, false);
}

Cell all_of(const Tally& tally) { return report::sum_of(tally.operations); }

std::set<Verdict> verdicts(const std::string& log, JudgeOptions options = {}) {
  std::set<Verdict> found;
  for (const auto& [outcome, count] : all_of(judged({log}, std::move(options)).tally).outcomes)
    found.insert(outcome.verdict);
  return found;
}

std::size_t hardest(const std::string& log) {
  const TextFile file("hardest", log);
  std::size_t count = 0;
  for (const auto& [operation, questions] : hardest_of_logs({file.path()}, all_operations(), 1))
    count += questions.size();
  return count;
}

std::string repeated(const std::string& line, int times) {
  std::string lines;
  for (int i = 0; i < times; ++i) lines += line;
  return lines;
}

}  // namespace

TEST_CASE("judge: a run that is stopped twice counts no call twice") {
  JudgeOptions options;
  options.calls_of_a_piece = 300;
  std::vector<JudgedSoFar> states;
  options.after_piece = [&](const JudgedSoFar& state) { states.push_back(state); };
  const std::string log = repeated(left, 1000);
  judged({log}, options);
  REQUIRE(states.size() == 3);
  options.counted = states[1];
  CHECK(all_of(judged({log}, options).tally).cases() == 1000);
  REQUIRE(states.size() > 3);
  for (const JudgedSoFar& state : states) {
    CHECK(all_of(state.tally).cases() == state.read);
    CHECK(report::sum_of(state.tally.robust).cases() == state.read);
  }
}

TEST_CASE("judge: the calls of several logs are counted through, and each log is accounted for") {
  const std::string three = repeated(left, 3);
  JudgeOptions options;
  options.shards = 2;
  const JudgedLogs odd = judged({three, three}, options);  // calls 0, 2 and 4
  CHECK(all_of(odd.tally).cases() == 3);
  REQUIRE(odd.accounts.size() == 2);
  options.shard = 2;
  CHECK(all_of(judged({repeated(left, 4), left}, options).tally).cases() == 2);  // calls 1 and 3
  options = {};
  options.operations = {find_operation("segment_segment")};
  CHECK(all_of(judged({three + touch}, options).tally).cases() == 1);
}

TEST_CASE("judge: boundary and tolerance are those of the log, or of the caller") {
  const std::string closed = header(R"("boundary":"closed")");
  CHECK(verdicts(closed + touch) == std::set{Verdict::algorithm});
  CHECK(verdicts(header(R"("boundary":"open")") + touch) == std::set{Verdict::convention});
  CHECK(verdicts(touch) == std::set{Verdict::convention});
  JudgeOptions open;
  open.boundary = Declaration::Boundary::open;
  CHECK(verdicts(closed + touch, open) == std::set{Verdict::convention});
  CHECK(verdicts(header(R"("tolerance":0.001)") + apart) == std::set{Verdict::tolerance});
  CHECK(verdicts(apart) == std::set{Verdict::algorithm});
  JudgeOptions tolerant;
  tolerant.tolerance = 0.001;
  CHECK(verdicts(apart, tolerant) == std::set{Verdict::tolerance});
}

TEST_CASE("judge: logs of two engines are refused, also where they stand in one file") {
  const std::string game = header(R"("engine":"game")") + left, other = header(R"("engine":"other")") + left,
                    open = header(R"("engine":"game","boundary":"open")") + left;
  for (const auto& logs : {std::vector{game, other}, {game + other}, {repeated(game, 300) + other}})
    CHECK_THROWS_WITH(judged(logs), EndsWith("engine: expected game, as the logs before it, got other"));
  CHECK_THROWS_WITH(judged({game, open}), EndsWith("boundary: expected unspecified, as the logs before it, got open"));
  CHECK_THROWS_WITH(judged({left + other}), EndsWith("engine: expected no name, as the logs before it, got other"));
  CHECK(all_of(judged({game + game}).tally).cases() == 2);
  JudgeOptions closed;
  closed.boundary = Declaration::Boundary::closed;
  CHECK(all_of(judged({game, open}, closed).tally).cases() == 2);
}

TEST_CASE("judge: each call is judged in its own number type") {
  CHECK(verdicts(third_in_float) == std::set{Verdict::agree});
  CHECK(judged({third_in_float}).tally.declaration.binary32);
  CHECK_FALSE(judged({third_in_float + left}).tally.declaration.binary32);
  CHECK_FALSE(judged({left}).tally.declaration.binary32);
  // The products are 1 + 2^-23 and 1: one rounding of a float apart.
  std::string near = R"({"op":"orientation","input":{"p0":[0,0],"p1":[1.00000011920928955078125,1],"p":[1,1]},)"
                     R"("answer":{"side":"left"},"number":"binary32"})"
                     "\n";
  CHECK(all_of(judged({near}).tally).recorded.nearness[1] == 1);
  CHECK(hardest(near) == 1);
  near.replace(near.find("binary32"), 8, "binary64");
  CHECK(all_of(judged({near}).tally).recorded.nearness[6] == 1);
  CHECK(hardest(near) == 0);
  CHECK(hardest(third_in_float) == 0);
}

TEST_CASE("judge: an answer is held against the truth with all its numbers") {
  const std::string question = R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,-1],[1,1]]},)";
  const auto of = [&](const std::string& answer) { return verdicts(left + question + answer + "}\n"); };
  CHECK(of(R"("answer":{"relation":"point","ta":0.5,"tb":0.5,"point":[1,0]})") == std::set{Verdict::agree});
  for (const char* wrong :
       {R"("answer":{"relation":"point","ta":0.25,"tb":0.5,"point":[1,0]})",
        R"("answer":{"relation":"point","ta":0.25})", R"("answer":{"relation":"point","point":[1,0.5]})"})
    CHECK(of(wrong) == std::set{Verdict::agree, Verdict::algorithm});
  CHECK(of(R"("error":"out of memory")") == std::set{Verdict::agree, Verdict::invalid});
  CHECK(hardest(question + R"("error":"out of memory"})"
                           "\n") == 1);
  CHECK(hardest(left) == 0);
}

TEST_CASE("judge: a call that is vouched for counts in every cell as one that is examined") {
  // The first call is examined, the others are not.
  const JudgedLogs both =
      judged({repeated(left, 2) + R"({"op":"orientation","input":{"p0":[0,0],"p1":[2,1],"p":["nan",5]},"answer":true})"
                                  "\n"});
  const Cell answers = all_of(both.tally), robust = report::sum_of(both.tally.robust);
  CHECK(answers.right_off_axis == 2);
  CHECK(robust.right_off_axis == 2);
  CHECK(answers.rules == robust.rules);
  CHECK(robust.rules.size() == 1);
  CHECK(answers.hash == seed_of(0, "orientation/agree/left/left", 0) + seed_of(1, "orientation/agree/left/left", 0));
  std::string yes = R"({"op":"segment_segment","input":{"a":[[0,0],[2,0]],"b":[[1,-1],[1,1]]},"answer":true})"
                    "\n";
  const JudgedLogs crossing = judged({left + yes});
  CHECK(crossing.tally.operations.at(0).total().outcomes.size() +
            crossing.tally.operations.at(1).total().outcomes.size() ==
        2);
  for (const auto& [outcome, count] : report::sum_of(crossing.tally.robust).outcomes)
    CHECK(outcome.answer == outcome.truth);
  for (const auto& [outcome, count] : all_of(crossing.tally).outcomes)
    CHECK(outcome.answer == (outcome.truth == "left" ? "left" : "true"));
}

TEST_CASE("judge: a class of nearness has its lower bound and not its upper one") {
  Recorded recorded;
  for (const double nearest :
       {0.0, 0x1p-1074, 0.5, 1.0, 9.0, 10.0, 100.0, 1e4, 1e6, 1e9, std::numeric_limits<double>::infinity()})
    recorded.add_nearness(nearest);
  CHECK(recorded.nearness == std::array<std::uint64_t, nearness_classes>{1, 2, 2, 1, 1, 1, 1, 2});
  recorded.in_double = 1, recorded.in_float = 2, recorded.as_open_sets = 3;
  Recorded sum;
  sum.merge(recorded), sum.merge(recorded);
  CHECK(sum.nearness == std::array<std::uint64_t, nearness_classes>{2, 4, 4, 2, 2, 2, 2, 4});
  CHECK(sum.calls() == 22);
  CHECK((sum.in_double == 2 && sum.in_float == 4 && sum.as_open_sets == 6));
}

TEST_CASE("judge: table and page show each count in its own column") {
  Tally tally;
  tally.logs = {"game.log"};
  Cell one, two;
  one.recorded.nearness = {11, 12, 13, 14, 15, 16, 17, 18};
  one.recorded.in_double = 21, one.recorded.in_float = 22, one.recorded.as_open_sets = 23;
  two.recorded.nearness[7] = 116;
  tally.operations.push_back({"orientation", {{"a.c:1", one}, {"b.c:2", two}}});
  const std::string table = report::recorded_table(tally);
  CHECK_THAT(table, ContainsSubstring(
                        "orientation            11  12   13    14    15    16    17   134      21     22    23\n"));
  CHECK_THAT(table, ContainsSubstring(
                        "  a.c:1                11  12   13    14    15    16    17    18      21     22    23\n"));
  const std::string page = report::nearness_section(tally.operations[0]);
  // calls, ties, within rounding, double, float, open
  CHECK_THAT(page, ContainsSubstring("<td>116</td><td>11</td><td>12</td><td>21</td><td>22</td><td>23</td>"));
  CHECK_THAT(page, ContainsSubstring("a.c:1") && ContainsSubstring("width:57.76%"));  // 134 of 232
}

}  // namespace touchstone::proptests::judged_logs_tests
