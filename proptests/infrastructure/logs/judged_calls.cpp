// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <set>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "audit/judging/call_judge.h"
#include "audit/judging/judge_logs.h"
#include "proptests/drawn.h"
#include "proptests/infrastructure/program/called.h"

namespace touchstone::proptests::judged_calls_tests {
namespace {

using namespace audit;
using Kind = RecordedAnswer::Kind;
using Outcomes = std::map<std::string, std::uint64_t>;

/// What an engine in double might have answered, in different detail; every seventh answer is that of another question.
RecordedAnswer answer_of(const Operation& operation, const Question& question, const Question& other, std::uint64_t i) {
  const Question& asked = i % 7 == 6 ? other : question;
  const auto value = i % 3 == 0 ? operation.row().robust(asked, 0) : operation.row().reference(asked);
  const Json whole = parse_line(one_line(operation.answer_json(value)));
  const std::optional<bool> yes = yes_or_no(operation.answer_shape(), value.words);
  if (i % 4 == 1 && yes) return recorded_answer(operation, *yes);
  if (i % 4 == 3 && whole.is_object()) {  // the decision alone
    Json decision = Json::object();
    decision[whole.begin().key()] = whole.begin().value();
    return recorded_answer(operation, decision);
  }
  return recorded_answer(operation, whole);
}

std::vector<RecordedCall> calls_of(const Operation& operation, std::uint64_t of_each_family) {
  std::vector<RecordedCall> calls;
  Question last;
  const std::size_t step = operation.metadata().cost > 20 ? 4 : 1;  // of dear operations some families
  for (std::size_t family = 0; family < operation.families().size(); family += step) {
    for (std::uint64_t i = 0; i < of_each_family; ++i) {
      DrawStream draws = case_draws(operation, family, 7, i);
      RecordedCall call;
      call.operation = &operation;
      call.question = operation.draw(draws, family);
      call.ordinal = calls.size() + 1;
      try {
        operation.examine(call.question);
        call.answer = answer_of(operation, call.question, calls.empty() ? call.question : last, i + family);
        last = call.question;
      } catch (const InvalidInput&) {
        call.answer = recorded_answer(operation, true);
      }
      calls.push_back(std::move(call));
    }
  }
  return calls;
}

std::string outcome_in_words(const JudgedOutcome& outcome) {
  return std::string(name_of(outcome.verdict)) + ": " + outcome.truth + ", answered " + outcome.answer;
}

/// "agree: left, answered true: 12", a line each.
std::string in_words(const Outcomes& outcomes) {
  std::string text;
  for (const auto& [outcome, count] : outcomes) text += outcome + ": " + std::to_string(count) + "\n";
  return text;
}

/// Every call held against the oracle, one by one.
Outcomes outcomes_by_examination(const std::vector<RecordedCall>& calls, const Declaration& declaration) {
  Outcomes outcomes;
  Cell refused_ones;
  for (const RecordedCall& call : calls) {
    try {
      const auto examination = call.operation->examine(call.question);
      const Judgement judgement = examination->judge_engine(answer_json(*call.operation, call.answer), declaration);
      ++outcomes[outcome_in_words(judged_outcome(judgement, examination->outcome()))];
    } catch (const InvalidInput& refused) {
      refused_ones.refuse(refused.rule());
    }
  }
  for (const auto& [rule, count] : refused_ones.rules) outcomes["refused: " + rule] += count;
  return outcomes;
}

Outcomes outcomes_of_cell(const Cell& cell) {
  Outcomes outcomes;
  for (const auto& [outcome, counted] : cell.outcomes) outcomes[outcome_in_words(outcome)] += both(counted.cases);
  for (const auto& [rule, count] : cell.rules) outcomes["refused: " + rule] += count;
  return outcomes;
}

CallJudge::Counted judged(const std::vector<RecordedCall>& calls, const Declaration& declaration) {
  CallJudge judge(declaration, {});
  for (const RecordedCall& call : calls) judge.judge(call);
  auto all = judge.take();
  REQUIRE(all.size() == 1);
  return all.begin()->second;
}

RecordedCall orientation_call(const std::string& points, const std::string& side) {
  const Operation& operation = *find_operation("orientation");
  RecordedCall call;
  call.operation = &operation;
  call.question = operation.parse(parse_line(points));
  call.answer = recorded_answer(operation, Json{{"side", side}});
  call.ordinal = 1;
  return call;
}

Recorded recorded_of(const RecordedCall& call) { return judged({call}, {}).answers.recorded; }

}  // namespace

TEST_CASE("what is vouched for is counted as the oracle would have it") {
  Declaration declaration;
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    // The two by turns.
    const bool closed = declaration.boundary == Declaration::Boundary::closed;
    declaration.boundary = closed ? Declaration::Boundary::unspecified : Declaration::Boundary::closed;
    const std::vector<RecordedCall> calls = calls_of(*operation, affordable(*operation, 3));
    INFO(operation->name());
    const CallJudge::Counted counted = judged(calls, declaration);
    CHECK(in_words(outcomes_of_cell(counted.answers)) == in_words(outcomes_by_examination(calls, declaration)));
    CHECK(counted.robust.findings() == 0);
    CHECK(counted.answers.recorded.calls() == counted.answers.cases());
  }
}

TEST_CASE("nearness is counted in units of the formula's own rounding") {
  // p is on the line, and the determinant is exactly 0.
  CHECK(recorded_of(orientation_call(R"({"p0":[0,0],"p1":[2,2],"p":[1,1]})", "on")).nearness[0] == 1);
  // The products are 1 + 2^-52 and 1, which one rounding of each may exchange.
  CHECK(recorded_of(orientation_call(R"({"p0":[0,0],"p1":[1.0000000000000002,1],"p":[1,1]})", "left")).nearness[1] ==
        1);
  // They are 1 and 0, 2^52 roundings apart.
  CHECK(recorded_of(orientation_call(R"({"p0":[0,0],"p1":[1,0],"p":[0,1]})", "left")).nearness.back() == 1);
}

TEST_CASE("recorded calls tell what float and open sets would have answered") {
  // 16777217 is 2^24 + 1, which float rounds to 2^24: there p is on the line.
  const RecordedCall beyond_float =
      orientation_call(R"({"p0":[0,0],"p1":[16777216,16777216],"p":[16777216,16777217]})", "left");
  CHECK(recorded_of(beyond_float).in_float == 1);
  CHECK(recorded_of(beyond_float).in_double == 0);
  // 2^53 - (-1) rounds to 2^53: in double the formula takes p, which is right of the line, to be on it.
  const RecordedCall beyond_double = orientation_call(
      R"({"p0":[-1,0],"p1":[9007199254740991,9007199254740992],"p":[9007199254740992,9007199254740992]})", "right");
  CHECK(recorded_of(beyond_double).in_double == 1);
  const Operation& operation = *find_operation("segment_segment");
  RecordedCall touch;
  touch.operation = &operation;
  touch.question = operation.parse(parse_line(R"({"a":[[0,0],[2,0]],"b":[[1,0],[1,1]]})"));
  touch.answer = recorded_answer(operation, true);
  touch.ordinal = 1;  // no call that is examined in any case
  const Cell counted = judged({touch}, {}).answers;
  CHECK(counted.recorded.as_open_sets == 1);
  CHECK(counted.touches_closed == 1);
}

TEST_CASE("shards of a log merge to the whole, whatever the jobs, and survive a file") {
  std::string log = R"({"touchstone_log":1,"engine":"game 1.0"})"
                    "\n";
  for (int i = 0; i < 3000; ++i)
    log += R"({"op":"orientation","input":{"p0":[0,0],"p1":[)" + std::to_string(1 + i % 5) + R"(,1],"p":[)" +
           std::to_string(i % 11) + R"(,2]},"answer":{"side":"left"},"site":"game.cpp:)" + std::to_string(i % 3) +
           "\"}\n";
  log += R"({"end":{"seen":3000,"written":3000,"sampled_out":0,"lost":0}})"
         "\n";
  const TextFile file("game.jsonl", log);
  JudgeOptions options;
  options.files = {file.path()};
  options.operations = all_operations();
  const std::atomic<bool> stop{false};
  const Tally whole = judge_logs(options, stop).tally;
  CHECK(whole.operations.at(0).total().cases() == 3000);
  CHECK(whole.operations.at(0).families.size() == 3);
  options.jobs = 3;
  CHECK(tally_json(judge_logs(options, stop).tally) == tally_json(whole));
  options.calls_of_a_piece = 700;
  std::vector<JudgedSoFar> states;
  options.after_piece = [&](const JudgedSoFar& so_far) { states.push_back(so_far); };
  CHECK(tally_json(judge_logs(options, stop).tally) == tally_json(whole));
  REQUIRE(states.size() == 4);
  CHECK(states[2].read == 2100);
  CHECK(states[2].tally.operations.at(0).total().cases() == 2100);
  options.counted = JudgedSoFar{read_tally(tally_json(states[2].tally)), states[2].read};
  CHECK(tally_json(judge_logs(options, stop).tally) == tally_json(whole));
  options.counted.reset();
  std::optional<Tally> merged;
  options.shards = 2;
  for (options.shard = 1; options.shard <= 2; ++options.shard) {
    const Tally part = read_tally(tally_json(judge_logs(options, stop).tally));
    merged ? merged->merge(part) : static_cast<void>(merged = part);
  }
  merged->grid = whole.grid;
  CHECK(tally_json(*merged) == tally_json(read_tally(tally_json(whole))));
}

TEST_CASE("judge exits with 1 where a recorded answer is wrong, and says where it was given") {
  const TextFile wrong(
      "wrong.jsonl",
      R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[0,1]},"answer":{"side":"right"},"site":"walk.cpp:7"})"
      "\n");
  const Called call = called({"judge", wrong.path()});
  CHECK(call.code == 1);
  CHECK_THAT(call.out, ContainsSubstring("walk.cpp:7") && ContainsSubstring("1 by algorithm"));
  CHECK(called({"judge", wrong.path(), "--fail-on", "none"}).code == 0);
  const std::string sarif = std::string(wrong.path()) + ".sarif";
  CHECK(called({"judge", wrong.path(), "--sarif", sarif.c_str()}).code == 1);
  const Json place = Json::parse(std::ifstream(sarif))["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
  CHECK(place["artifactLocation"]["uri"] == "walk.cpp");
  CHECK(place["region"]["startLine"] == 7);
  std::filesystem::remove(sarif);
  const TextFile empty("empty.jsonl", "");
  require_refused(called({"judge", empty.path()}), 2, "the log holds no call");
  require_refused(called({"judge", "no_such.jsonl"}), 2, "no_such.jsonl");
}

TEST_CASE("files are questions: pairs of geometries, and columns of numbers") {
  const TextFile engine("engine.py", R"(import json, sys
sys.stdin.readline()
print(json.dumps({"engine": "open sets", "ops": ["point_in_polygon", "orientation", "polygon_polygon"]}), flush=True)
for line in sys.stdin:
    question = json.loads(line)
    answer = {"side": "left"} if question["op"] == "orientation" else False
    print(json.dumps({"id": question["id"], "answer": answer}), flush=True)
)");
  const std::string command = std::string("python3 ") + engine.path();
  // The first two overlap, the third is apart from both.
  const TextFile rings(
      "rings.wkt",
      "POLYGON ((0 0, 4 0, 0 4, 0 0))\nPOLYGON ((1 1, 5 1, 1 5, 1 1))\nPOLYGON ((9 9, 10 9, 9 10, 9 9))\n");
  const Called pairs = called({"judge", "--pairs", "polygon_polygon", rings.path(), "--engine", command.c_str()});
  INFO(pairs.out + pairs.err);
  CHECK(pairs.code == 1);
  CHECK_THAT(pairs.out, ContainsSubstring("1 of 3 answers wrong") && ContainsSubstring("rings.wkt:1") &&
                            ContainsSubstring("rings.wkt:2"));
  const TextFile table("points.csv", "x0,y0,x1,y1,x,y\n0,0,1,0,0,1\n0,0,1,0,0,-1\n");
  const Called columns = called({"judge", "--columns", "orientation", table.path(), "--engine", command.c_str()});
  CHECK_THAT(columns.out, ContainsSubstring("1 of 2 answers wrong"));
  const TextFile short_row("short.csv", "0,0,1,0,0,1\n0,0,1\n");
  require_refused(called({"judge", "--columns", "orientation", short_row.path(), "--engine", command.c_str()}), 2,
                  "line 2: expected 6 numbers, got 3");
  require_refused(called({"judge", "--pairs", "orientation", rings.path(), "--engine", command.c_str()}), 2,
                  "expected an operation of two shapes");
  require_refused(called({"judge", "--pairs", "polygon_polygon", rings.path()}), 2, "--engine");
}

TEST_CASE("the hardest calls become vectors that hold") {
  std::string log;
  for (const char* p : {"[1,1]", "[3,3]", "[0.3,0.30000000000000004]", "[0,5]", "[5,0]"})
    log += std::string(R"({"op":"orientation","input":{"p0":[0,0],"p1":[2,2],"p":)") + p +
           R"(},"answer":{"side":"left"}})"
           "\n";
  const TextFile file("hard.jsonl", log);
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_own_vectors");
  const Called from = called({"vectors", "from", file.path(), "--to", folder.c_str()});
  INFO(from.out + from.err);
  CHECK(from.code == 0);
  // On the line, wrongly left of it; and right of it. [0,5] is left and far from the line.
  std::ifstream written(folder / "orientation.jsonl");
  std::set<std::string> truths;
  for (std::string line; std::getline(written, line);)
    truths.insert(parse_line(line)["truth"]["side"].get<std::string>());
  CHECK(truths == std::set<std::string>{"left", "on", "right"});
  CHECK(called({"vectors", "check", folder.c_str()}).code == 0);
  std::filesystem::remove_all(folder);
}

TEST_CASE("two engines that part are shown where, and who is right") {
  const auto engine = [](const std::string& name, const std::string& test) {
    return TextFile(name, "import json, sys\nsys.stdin.readline()\nprint(json.dumps({'engine': '" + name +
                              "', 'ops': ['orientation'], 'boundary': 'closed'}), flush=True)\nfor line in "
                              "sys.stdin:\n    q = json.loads(line)\n    a, b, c = (q['input'][k] for k in ('p0', "
                              "'p1', 'p'))\n    s = (b[0]-a[0])*(c[1]-a[1]) - (b[1]-a[1])*(c[0]-a[0])\n    "
                              "print(json.dumps({'id': q['id'], 'answer': {'side': " +
                              test + "}}), flush=True)\n");
  };
  const TextFile before = engine("before.py", "'left' if s > 0 else 'right' if s < 0 else 'on'"),
                 after = engine("after.py", "'left' if s >= 0 else 'right'");
  const std::string first = std::string("python3 ") + before.path(), second = std::string("python3 ") + after.path();
  const Called call = called({"audit", "--engine", first.c_str(), "--against", second.c_str(), "--ops", "orientation",
                              "--cases", "500", "--json", "-"});
  INFO(call.out + call.err);
  CHECK(call.code == 1);
  const Json kinds = Json::parse(call.out)["operations"][0]["parted"];
  const auto right_and_wrong = std::find_if(kinds.begin(), kinds.end(), [](const Json& kind) {
    return kind["first"] == "agree" && kind["second"] == "algorithm";
  });
  REQUIRE(right_and_wrong != kinds.end());
  // No more points are equal than in the question that was drawn, of which two are.
  // As generic as the question that was drawn, in which p is another point than p0.
  CHECK((*right_and_wrong)["smallest"]["input"] == Json::parse(R"({"p0":[0,0],"p1":[0,0],"p":[1,0]})"));
  const Called same = called(
      {"audit", "--engine", first.c_str(), "--against", first.c_str(), "--ops", "orientation", "--cases", "200"});
  CHECK(same.code == 0);
}

}  // namespace touchstone::proptests::judged_calls_tests
