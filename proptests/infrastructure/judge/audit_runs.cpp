// SPDX-License-Identifier: Apache-2.0
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "audit/counting/audit_run.h"
#include "audit/counting/cases_of.h"
#include "audit/counting/generic.h"
#include "audit/counting/tally_json.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/screen/table.h"

namespace touchstone::proptests::audit_runs_tests {
namespace {

/// An engine of one line: what it makes of the right answer. Null: unsupported.
class Scripted final : public Engine {
 public:
  using Answer = std::function<Json(const Question&, const Examination&)>;
  Scripted(Answer answer, Declaration declaration) : answer_(std::move(answer)), declaration_(std::move(declaration)) {}

  const Declaration& declaration() const override { return declaration_; }
  bool supports(const std::string& operation) const override { return operation != "ray_segment"; }
  void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (over_ && over_()) {
        take(i, {Reply::Kind::failed, nullptr, "the time is over", false});
        continue;
      }
      const Json answer = answer_(questions[i], *operation.examine(questions[i]));
      if (answer.is_null()) {
        take(i, {Reply::Kind::unsupported, nullptr, ""});
      } else if (answer.contains("not asked")) {
        take(i, {Reply::Kind::failed, nullptr, "given up", false});
      } else if (answer.contains("failure")) {
        take(i, {Reply::Kind::failed, nullptr, answer["failure"].get<std::string>()});
      } else {
        take(i, {Reply::Kind::answered, parse_line(one_line(answer)), ""});
      }
    }
  }
  void ask_until(const std::function<bool()>& over) override { over_ = over; }

 private:
  Answer answer_;
  Declaration declaration_;
  std::function<bool()> over_;
};

Json right(const Question&, const Examination& examination) { return examination.rounded_truth(); }

bool is_refused(const Operation& operation, const Question& question) {
  try {
    operation.examine(question);
    return false;
  } catch (const InvalidInput&) {
    return true;
  }
}

struct Run {
  const char* operation = "orientation";
  std::vector<std::string> families{};
  std::uint64_t cases = 3000, seed = 1;
  int jobs = 1;
  Scripted::Answer answer{};
  Declaration declaration{"scripted", Declaration::Boundary::closed, false, 0};

  Tally tally(bool stopped = false) const {
    AuditOptions options;
    options.operations = {find_operation(operation)};
    options.families = families;
    options.cases = cases;
    options.seed = seed;
    options.jobs = jobs;
    if (answer) options.engine = [this] { return std::make_unique<Scripted>(answer, declaration); };
    return run_audit(options, stopped, [](const std::string&, std::uint64_t) {});
  }
};

}  // namespace

TEST_CASE("audit_runs: the same seed gives the same tally whatever the number of jobs, another seed another") {
  for (const char* operation : {"orientation", "segment_segment", "line_point_at"}) {
    Run run{.operation = operation, .cases = 5000};
    const std::string alone = tally_json(run.tally());
    CHECK(tally_json(run.tally()) == alone);
    run.jobs = 3;
    CHECK(tally_json(run.tally()) == alone);
    run.seed = 2;
    CHECK(tally_json(run.tally()) != alone);
  }
}

TEST_CASE("audit_runs: every case is counted once, in its family, for engine and robust alike") {
  const Tally tally = Run{.cases = 3001, .answer = right}.tally();
  REQUIRE(tally.operations.size() == 1);
  const auto& families = tally.operations[0].families;
  CHECK(families.size() == find_operation("orientation")->families().size());
  std::uint64_t sum = 0;
  for (const auto& [family, cell] : families) sum += cell.cases() + cell.refused;
  CHECK(sum == 3001);
  CHECK(tally.operations[0].total().count(Verdict::agree) == tally.operations[0].total().cases());
  CHECK(tally.robust[0].total().cases() == tally.operations[0].total().cases());
  CHECK_FALSE(tally.has_findings());
}

TEST_CASE("audit_runs: a decision answered wrongly is found and shrunk to the smallest question of its kind") {
  const auto says_right_for_left = [](const Question&, const Examination& examination) -> Json {
    return {{"side", examination.outcome() == "left" ? "right" : examination.outcome()}};
  };
  const Tally tally = Run{.families = {"grid"}, .answer = says_right_for_left}.tally();
  const Cell& cell = tally.operations[0].families[0].second;
  CHECK(cell.count(Verdict::algorithm) + cell.count(Verdict::rounding) == cell.truths().at("left"));
  CHECK(cell.truths().at("left") > 0);
  CHECK(tally.has_findings());
  const Finding* found = cell.example(Verdict::algorithm);
  REQUIRE(found);
  CHECK(found->answer == Json{{"side", "right"}});
  // A triangle of positive area needs two coordinates that are not 0; the grid has 1, 2 and 3.
  INFO(one_line(find_operation("orientation")->print(found->question)));
  const std::vector<double>& n = found->question.numbers;
  CHECK(std::count(n.begin(), n.end(), 0.0) == 4);
  CHECK(*std::max_element(n.begin(), n.end()) <= 3);
}

TEST_CASE("audit_runs: an engine that is wrong beyond a threshold is shrunk to the threshold") {
  // In that family the segment is one point, and on means that the point is the same: (40, 0) is the simplest from 40
  // on.
  const auto blind_beyond = [](const Question& q, const Examination& examination) -> Json {
    return examination.outcome() == "on" && q.numbers[0] >= 40 ? Json{{"relation", "off"}}
                                                               : examination.rounded_truth();
  };
  const Tally tally = Run{.operation = "point_on_segment", .families = {"zero_length"}, .answer = blind_beyond}.tally();
  const Finding* found = tally.operations[0].families[0].second.example(Verdict::algorithm);
  REQUIRE(found);
  const std::vector<double>& n = found->question.numbers;
  INFO(one_line(find_operation("point_on_segment")->print(found->question)));
  CHECK(n[0] == 40);
  CHECK(n == std::vector<double>{40, 0, 40, 0, 40, 0});
}

TEST_CASE("audit_runs: what is shown is never a worse example than what was found") {
  for (const char* name : {"segment_segment", "point_on_segment", "explicit_line", "implicit_circle"}) {
    const Operation& operation = *find_operation(name);
    const std::uint64_t each = 40;
    const Tally tally = Run{.operation = name, .cases = each * operation.families().size()}.tally();
    for (std::size_t family = 0; family < operation.families().size(); ++family) {
      for (std::uint64_t i = 0; i < each; ++i) {
        DrawStream draws = case_draws(operation, family, 1, i);
        const Question question = operation.draw(draws, family);
        if (is_refused(operation, question)) continue;
        const auto examination = operation.examine(question);
        const Judgement judgement = examination->judge_reference();
        if (judgement.verdict == Verdict::agree) continue;
        const Cell& cell = tally.operations[0].families[family].second;
        const auto& shown = cell.outcomes.at(judged_outcome(judgement, examination->outcome())).example;
        INFO(name << " " << operation.families()[family] << " " << i);
        REQUIRE(shown);
        CHECK(shown->judgement.verdict == judgement.verdict);
        CHECK(shown->judgement.said == judgement.said);
        CHECK_FALSE(shown->answer.is_null());
        const std::size_t features = degenerate_features(operation, question, judgement.degenerate);
        CHECK_FALSE(shown_before({question, judgement, nullptr, i, range_of(question), features}, *shown));
      }
    }
  }
}

TEST_CASE("audit_runs: the example shown is no more degenerate than its bug needs") {
  // `<` for `<=`: balls that touch, with radii, in two places.
  const auto open = [](const Question&, const Examination& examination) {
    return examination.touch() ? parse_line(R"({"contact":"disjoint"})") : examination.rounded_truth();
  };
  const Cell total = Run{.operation = "sphere_sphere", .cases = 2000, .answer = open}.tally().operations[0].total();
  const Finding* const shown = total.example(Verdict::algorithm);
  REQUIRE(shown != nullptr);
  INFO(one_line(find_operation("sphere_sphere")->print(shown->question)));
  CHECK(shown->features == 1);
}

TEST_CASE("audit_runs: alternatives that an engine does not declare are not asked, and are no unsupported questions") {
  Run run{.operation = "sphere_sphere", .answer = [](const Question& question, const Examination& examination) {
            return question.words[0] == 1 ? examination.rounded_truth() : Json(nullptr);
          }};
  run.declaration.alternatives["sphere_sphere"] = {1};
  const Cell in_space = run.tally().operations[0].total();
  CHECK(in_space.count(Verdict::unsupported) == 0);
  CHECK(in_space.other_alternative > 500);
  CHECK(in_space.cases() + in_space.refused + in_space.other_alternative == run.cases);
  run.declaration.alternatives.clear();
  CHECK(run.tally().operations[0].total().count(Verdict::unsupported) > 500);
}

TEST_CASE("audit_runs: failures are invalid with their remark, silence is unsupported, neither stops the run") {
  const auto moody = [](const Question& q, const Examination& examination) -> Json {
    if (q.numbers[0] < 0) return nullptr;
    if (q.numbers[0] > 0) return {{"failure", "fell over"}};
    return examination.rounded_truth();
  };
  const Cell cell = Run{.families = {"grid", "random", "collinear"}, .answer = moody}.tally().operations[0].total();
  CHECK(cell.count(Verdict::unsupported) > 0);
  CHECK(cell.count(Verdict::agree) > 0);
  const Finding* failed = cell.example(Verdict::invalid);
  REQUIRE(failed);
  CHECK(failed->judgement.remark == "fell over");
  CHECK_THROWS_AS((Run{.operation = "ray_segment", .answer = right}.tally()),
                  EngineError);  // it has nothing that was asked
}

TEST_CASE("audit_runs: of a long answer no more is kept than a finding shows") {
  const Json long_list(20'000, 12345);  // more than a megabyte once it is read
  std::size_t least = SIZE_MAX, most = 0;
  const auto at_length = [&](const Question&, const Examination& examination) -> Json {
    const std::size_t in_use = mallinfo2().uordblks;
    least = std::min(least, in_use), most = std::max(most, in_use);
    return {{"side", examination.outcome() == "left" ? Json("right") : long_list}};
  };
  const Cell cell = Run{.cases = 300, .answer = at_length}.tally().operations[0].total();
  CHECK(cell.count(Verdict::invalid) > 100);
  const Finding* found = cell.example(Verdict::invalid);
  REQUIRE(found);
  CHECK(one_line(found->answer).size() < 5000);
  CHECK(most - least < 20'000'000);
}

TEST_CASE("audit_runs: what was never asked is counted apart, and is no wrong answer") {
  const auto given_up_on_small = [](const Question& q, const Examination&) -> Json {
    if (std::fabs(q.numbers[0]) < 3) return {{"not asked", true}};
    return {{"failure", "fell over"}};
  };
  const Cell cell = Run{.families = {"grid"}, .answer = given_up_on_small}.tally().operations[0].total();
  CHECK(cell.count(Verdict::invalid) == cell.cases());
  CHECK(cell.not_asked > 0);
  CHECK(cell.cases() + cell.not_asked == 3000);
  CHECK(cell.given_up == "given up");
  const Tally none = Run{
      .families = {"grid"}, .answer = [](const Question&, const Examination&) -> Json {
        return {{"not asked", true}};
      }}.tally();
  CHECK(none.operations[0].total().cases() == 0);
  CHECK(none.has_findings());
  CHECK_THAT(text_table(none),
             ContainsSubstring("0 of 0 answers wrong; 3,000 not asked") &&
                 ContainsSubstring("orientation: 3,000 questions not asked: the engine was given up"));
  CHECK(tally_json(read_tally(tally_json(none))) == tally_json(none));
  const Finding* failed = cell.example(Verdict::invalid);
  REQUIRE(failed);
  CHECK(failed->judgement.remark == "fell over");
}

TEST_CASE("audit_runs: touch as contact here and not there is an inconsistent convention, always the same is not") {
  const auto closed_until = [](double limit) {
    return [limit](const Question& q, const Examination& examination) -> Json {
      return examination.touch() && q.numbers[0] > limit ? Json{{"relation", "disjoint"}} : examination.rounded_truth();
    };
  };
  Run run{.operation = "segment_segment", .families = {"shared_end", "end_on_segment"}};
  run.declaration.boundary = Declaration::Boundary::open;
  const auto inconsistent = [&](double limit) {
    run.answer = closed_until(limit);
    const Tally tally = run.tally();
    CHECK(tally.operations[0].total().count(Verdict::algorithm) == 0);
    CHECK(tally.has_findings() == tally.operations[0].inconsistent_convention());
    return tally.operations[0].inconsistent_convention();
  };
  CHECK(inconsistent(0));
  CHECK_FALSE(inconsistent(HUGE_VAL));   // always closed
  CHECK_FALSE(inconsistent(-HUGE_VAL));  // always open
}

TEST_CASE("audit_runs: a binary32 engine is asked numbers that are floats") {
  bool all_floats = true;
  Run run{.cases = 2000, .answer = [&](const Question& q, const Examination& examination) -> Json {
            for (const double n : q.numbers) all_floats = all_floats && static_cast<double>(static_cast<float>(n)) == n;
            return examination.rounded_truth();
          }};
  run.declaration.binary32 = true;
  CHECK_FALSE(run.tally().has_findings());
  CHECK(all_floats);
}

TEST_CASE("audit_runs: a limit of time is looked at before each answer, also while findings are made smaller") {
  // A clock that goes by a second at each answer of the engine, which is wrong each time.
  double now = 0;
  std::uint64_t asked = 0;
  const auto wrong = [&](const Question&, const Examination& examination) -> Json {
    ++now, ++asked;
    return {{"side", examination.outcome() == "left" ? "right" : "left"}};
  };
  AuditOptions options;
  options.operations = {find_operation("orientation")};
  options.cases = 100'000;
  options.clock = [&] { return now; };
  options.engine = [&] {
    return std::make_unique<Scripted>(wrong, Declaration{"scripted", Declaration::Boundary::closed, false, 0});
  };
  const auto run = [&](double seconds) {
    now = 0, asked = 0, options.seconds = seconds;
    return run_audit(options, false, [](const std::string&, std::uint64_t) {}).operations[0].total();
  };
  const Cell cell = run(40);
  CHECK(asked == 40);
  CHECK(cell.cases() == 40);  // each answer counts
  CHECK(cell.not_asked == 0);
  CHECK(cell.example(Verdict::algorithm)->answer.contains("side"));
  // 500 cases, and each finding may cost 300 answers to make smaller: that ends with the limit as well.
  options.cases = 500;
  run(700);
  CHECK(asked == 700);
  run(0);
  CHECK(asked > 1000);
  // Ours as well: the clock goes by itself.
  options.engine = nullptr;
  options.clock = [&] { return ++now; };
  options.cases = 100'000;
  CHECK(run(300).cases() < 300);
}

TEST_CASE("audit_runs: what the engine does not declare is not asked, and is named") {
  AuditOptions options;
  options.operations = {find_operation("orientation"), find_operation("ray_segment")};
  options.cases = 100;
  options.engine = [] {
    return std::make_unique<Scripted>(right, Declaration{"scripted", Declaration::Boundary::closed, false, 0});
  };
  const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
  REQUIRE(tally.operations.size() == 1);
  CHECK(tally.operations[0].operation == "orientation");
  CHECK(tally.robust.size() == 1);
  CHECK(tally.undeclared == std::vector<std::string>{"ray_segment"});
  CHECK_FALSE(tally.has_findings());
  CHECK_THAT(text_table(tally),
             ContainsSubstring("\ndeclared: orientation\nnot declared, so not asked: ray_segment\n"));
  CHECK(read_tally(tally_json(tally)).undeclared == tally.undeclared);
}

TEST_CASE("audit_runs: by cost, fewer cases are asked of what costs more than ten of the cheapest, and it is said") {
  const auto of_cost = [](int cost, std::uint64_t cases) {
    RowFunctions row = find_operation("orientation")->row();
    Metadata metadata = *row.metadata;
    metadata.cost = cost;
    row.metadata = &metadata;
    return cases_of(Operation(row), cases, true);
  };
  CHECK(of_cost(1, 2000) == 2000);
  CHECK(of_cost(10, 2000) == 2000);
  CHECK(of_cost(40, 2000) == 500);
  CHECK(of_cost(1000, 2000) == 100);
  CHECK(of_cost(1000, 40) == 40);
  CHECK(cases_of(*find_operation("triangle_triangle"), 340, false) == 340);
  REQUIRE(find_operation("triangle_triangle")->metadata().cost == 17);
  AuditOptions options;
  options.operations = {find_operation("triangle_triangle")};
  options.cases = 340, options.by_cost = true;
  const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
  const Cell total = tally.operations[0].total();
  CHECK(total.cases() + total.refused == 200);
  CHECK(read_tally(tally_json(tally)).by_cost);
  CHECK_THAT(text_table(tally), ContainsSubstring("; up to 340 cases per operation, seed 1"));
}

TEST_CASE("audit_runs: of an ordinary range no extreme question reaches the engine") {
  bool all_ordinary = true;
  AuditOptions options;
  options.operations = {find_operation("orientation")};
  options.cases = 2000;
  options.ordinary_only = true;
  options.engine = [&] {
    return std::make_unique<Scripted>(
        [&](const Question& q, const Examination& examination) -> Json {
          all_ordinary = all_ordinary && range_of(q) == Range::ordinary;
          return examination.rounded_truth();
        },
        Declaration{"scripted", Declaration::Boundary::closed, false, 0});
  };
  const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
  const Cell cell = tally.operations[0].total();
  CHECK(all_ordinary);
  CHECK(cell.left_out > 0);
  CHECK(cell.cases() + cell.refused + cell.left_out == 2000);
  CHECK_FALSE(tally.has_findings());
  CHECK(tally_json(read_tally(tally_json(tally))) == tally_json(tally));
}

TEST_CASE("audit_runs: a stopped run says so and keeps what there is") {
  const Tally tally = Run{.answer = right}.tally(true);
  CHECK(tally.interrupted);
  CHECK_FALSE(Run{.cases = 100}.tally().interrupted);
}

}  // namespace touchstone::proptests::audit_runs_tests
