// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "audit/counting/audit_run.h"
#include "audit/counting/shrink_examples.h"
#include "audit/counting/tally_json.h"
#include "audit/gate/junit.h"
#include "audit/gate/sarif.h"
#include "audit/gate/shown.h"
#include "catalogue/judge/environment.h"
#include "catalogue/operation/probes/explained.h"
#include "proptests/any_robust_bits.h"
#include "proptests/catch.h"
#include "proptests/interrogation.h"
#include "proptests/uses.h"
#include "report/pages/html.h"
#include "report/screen/table.h"

/// A question is solved once, whatever is asked of it. Counted on an operation whose functions are those of
/// orientation, and count.
namespace touchstone::proptests::solved_once_tests {
namespace {

const Operation& orientation() { return *find_operation("orientation"); }
const RowFunctions& counted_row() { return orientation().row(); }

/// How often which function was asked about `asked`; about any question where that is empty.
struct Counts {
  Question asked;
  int solved = 0, certified = 0, formula = 0, exactly = 0, tracked = 0, tracked_in_float = 0, drawn = 0;
  std::array<int, environment_count> robust{}, decided{};
  /// Solutions that no other examination of the question has: what shows them was read from this one.
  bool marked = false;
};
Counts counts;

void add(int& count, const Question& question) { count += counts.asked.numbers.empty() || counts.asked == question; }

Solution solved(const Question& question) {
  add(counts.solved, question);
  Solution solution = counted_row().solve(question);
  const auto certificate = solution.certificate;
  solution.certificate = [=] { return add(counts.certified, question), certificate(); };
  if (counts.marked) solution.answer.words = {static_cast<Word>(Side::on)}, solution.margin = mpq_class(4242, 7);
  return solution;
}

RowFunctions counting() {
  RowFunctions row = counted_row();
  row.solve = solved;
  row.reference = [](const Question& q) { return add(counts.formula, q), counted_row().reference(q); };
  row.reference_exactly = [](const Question& q) { return add(counts.exactly, q), counted_row().reference_exactly(q); };
  row.reference_tracked.ask = [](const Question& q, bool binary32) {
    add(binary32 ? counts.tracked_in_float : counts.tracked, q);
    return counted_row().reference_tracked.ask(q, binary32);
  };
  row.robust = [](const Question& q, std::size_t e) { return add(counts.robust[e], q), counted_row().robust(q, e); };
  row.decide = [](const Question& q, std::size_t e) { return add(counts.decided[e], q), counted_row().decide(q, e); };
  row.draw = [](Drawing& drawing, const Question& q, const EncodedValue<double>& truth) {
    add(counts.drawn, q);
    counted_row().draw(drawing, q, truth);
  };
  return row;
}
const Operation& operation() {
  static const Operation counted(counting());
  return counted;
}

const Question to_the_left{{0.5, 0.25, 3, 1, 1, 7}, {}};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("solved once: a finding in table, JSON, gate, JUnit, SARIF and its card with figure and certificate") {
  counts = {.marked = true};
  Cell cell;
  count(cell, {operation(), to_the_left, "on"}, {Verdict::algorithm}, Json{{"side", "left"}});
  const Finding& finding = *cell.example(Verdict::algorithm);
  const Finding copy = finding;
  CHECK(counts.solved == 0);
  CHECK(copy.examination(operation()).outcome() == "on");
  CHECK(&finding.examination(operation()) == &copy.examination(operation()));
  Tally tally;
  tally.declaration = {"by hand", Declaration::Boundary::closed, false, 0};
  tally.operations = {{"orientation", {{"collinear", cell}}}};
  const GateResult gate = held_against(tally, {});
  const std::string truth = R"({"side":"on"})";
  for (int twice = 0; twice < 2; ++twice) {
    CHECK(contains(text_table(tally), truth + "   margin 4242/7"));
    CHECK(contains(tally_json(tally), "\"truth\":" + truth));
    CHECK(contains(described(tally, "orientation", finding), "truth:  " + truth));
    CHECK_FALSE(gate_in_words(tally, gate).empty());
    CHECK(contains(junit_xml(tally, gate), "&quot;on&quot;"));
    CHECK(contains(sarif_json(tally, {}, gate, "engine.cpp"), R"({\"side\":\"on\"})"));
    const std::string page = operation_page(tally, 0, {});
    CHECK(contains(page, "4242/7"));
    CHECK(contains(page, "Certificate of the truth"));
  }
  CHECK(counts.solved == 1);
  CHECK(counts.certified == 1);
  CHECK(counts.drawn == 1);
  CHECK(counts.formula == 1);
  CHECK(counts.exactly <= 1);
  CHECK(counts.tracked <= 1);
  CHECK(counts.tracked_in_float == 1);
  CHECK(counts.robust[0] == 1);
  CHECK(counts.decided[0] == 1);
}

TEST_CASE("solved once: the shrinker hands over the examination that it made last") {
  counts = {};
  AuditOptions options;
  options.operations = {&operation()};
  options.cases = 400;
  const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
  const int until_then = counts.solved;
  int shown = 0;
  for (const auto& [family, cell] : tally.operations[0].families) {
    for (const auto& [outcome, counted] : cell.outcomes) {
      if (!counted.example) continue;
      CHECK(counted.example->examination(operation()).outcome() == outcome.truth);
      ++shown;
    }
  }
  CHECK(shown > 0);
  CHECK(counts.solved == until_then);
}

TEST_CASE("solved once: findings are made smaller within a budget of solves, the smaller the more an operation costs") {
  // The effort is 100 solves where one costs 50, and 2,000, which is 5 a case, where it costs 1.
  for (const auto& [cost, most] : {std::pair(50, 100), std::pair(1, 2000)}) {
    RowFunctions row = counting();
    Metadata metadata = *row.metadata;
    metadata.cost = cost;
    row.metadata = &metadata;
    const Operation altered(row);
    CHECK(effort_to_shrink(altered, 400) == static_cast<std::uint64_t>(most) * static_cast<std::uint64_t>(cost));
    AuditOptions options;
    options.operations = {&altered};
    options.cases = 400;
    std::vector<std::size_t> reported;
    options.smaller = [&](const Operation& of, std::size_t done, std::size_t all) {
      CHECK(&of == &altered);
      CHECK(done <= all);
      reported.push_back(done);
    };
    counts = {};
    const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
    const int solved = counts.solved - 400;
    INFO("cost " << cost << ", " << solved << " solves");
    CHECK(solved > most / 4);
    CHECK(solved <= most + most / 2);
    CHECK_FALSE(reported.empty());
    for (std::size_t i = 0; i < reported.size(); ++i) CHECK(reported[i] == i + 1);
    // What was not made smaller has the answer that was counted.
    for (const auto& [family, cell] : tally.operations[0].families)
      for (const auto& [outcome, counted] : cell.outcomes)
        if (counted.example) CHECK_FALSE(counted.example->answer.is_null());
    options.jobs = 3;
    options.smaller = nullptr;
    CHECK(tally_json(run_audit(options, false, [](const std::string&, std::uint64_t) {})) == tally_json(tally));
  }
}

TEST_CASE("solved once: what the oracle refuses is not solved again") {
  counts = {};
  const Finding finding{{{0, 0, 1, 0, 0, HUGE_VAL}, {}}, {}, nullptr};
  for (int twice = 0; twice < 2; ++twice) CHECK_THROWS_AS(finding.examination(operation()), InvalidInput);
  CHECK(counts.solved == 1);
}

TEST_CASE("solved once: a certificate is checked without an answer of robust or of the formula") {
  counts = {};
  const Examination examination(operation(), to_the_left);
  CHECK(certificate_complaint(examination).empty());
  CHECK(counts.solved == 1);
  CHECK(counts.certified == 1);
  CHECK(counts.robust[0] + counts.formula == 0);
}

TEST_CASE("solved once: an interrogation asks robust once in each of two environments") {
  counts = {.asked = to_the_left};
  const std::size_t other = proptests::environment_of(to_the_left);
  const proptests::Aspects all = proptests::aspects_of(operation());
  CHECK(all.all());
  CHECK(proptests::interrogated(operation(), to_the_left, all).empty());
  CHECK(counts.solved == 1);
  CHECK(counts.certified == 1);
  CHECK(counts.formula == 1);
  CHECK(counts.exactly == 1);
  CHECK(counts.tracked == 1);
  for (std::size_t environment = 0; environment < environment_count; ++environment) {
    const int expected = environment == 0 || environment == other;
    CHECK(counts.robust[environment] == expected);
    CHECK(counts.decided[environment] == expected);
  }
}

TEST_CASE("interrogation: says which of its aspects is broken") {
  RowFunctions row = counted_row();
  const auto said = [&row](proptests::Aspect aspect, const Question& question = to_the_left) {
    const Operation altered(row);
    proptests::Aspects alone;
    alone.set(static_cast<std::size_t>(aspect));
    const std::string all = proptests::interrogated(altered, question, proptests::aspects_of(altered)),
                      one = proptests::interrogated(altered, question, alone);
    CHECK(all.empty() == one.empty());
    return one.substr(0, one.find(':'));
  };
  using proptests::Aspect;
  for (const Aspect aspect : {Aspect::robust, Aspect::stages, Aspect::promise, Aspect::certificate,
                              Aspect::laws_of_robust, Aspect::laws_of_oracle})
    CHECK(said(aspect).empty());

  const auto original = row;
  row.robust = [](const Question&, std::size_t) { return EncodedValue<double>{{}, {static_cast<Word>(Side::on)}}; };
  CHECK(said(Aspect::robust) == "robust");
  CHECK(said(Aspect::stages) == "stage 0");
  row.robust = [](const Question& q, std::size_t e) {
    return e == 0 ? counted_row().robust(q, e) : EncodedValue<double>{{}, {static_cast<Word>(Side::on)}};
  };
  CHECK(said(Aspect::robust) == "robust");
  row.robust = [](const Question&, std::size_t) -> EncodedValue<double> { throw InvalidInput("p", "another rule"); };
  CHECK(said(Aspect::robust) == "robust");
  CHECK(said(Aspect::robust, {{0, 0, 1, 0, 0, HUGE_VAL}, {}}) == "refusal");
  row = original;
  row.prepared = original.robust;
  CHECK(said(Aspect::robust).empty());
  row.prepared = [](const Question&, std::size_t) { return EncodedValue<double>{{}, {static_cast<Word>(Side::on)}}; };
  CHECK(said(Aspect::robust) == "robust");

  row = original;
  row.reference = [](const Question&) { return EncodedValue<double>{{}, {static_cast<Word>(Side::on)}}; };
  CHECK(said(Aspect::promise) == "promise");
  row = original;
  row.solve = [](const Question& q) {
    Solution solution = counted_row().solve(q);
    solution.certificate = [] { return oracle::Certificate{"no such kind", {}}; };
    return solution;
  };
  CHECK(said(Aspect::certificate) == "certificate");
  row = original;
  row.robust = [](const Question& q, std::size_t e) {
    return q == to_the_left ? counted_row().robust(q, e) : EncodedValue<double>{{}, {static_cast<Word>(Side::on)}};
  };
  CHECK(said(Aspect::laws_of_robust) == "law of robust");
  row = original;
  row.solve = [](const Question& q) {
    Solution solution = counted_row().solve(q);
    if (!(q == to_the_left)) solution.answer.words = {static_cast<Word>(Side::on)};
    return solution;
  };
  CHECK(said(Aspect::laws_of_oracle) == "law of the oracle");
}

}  // namespace touchstone::proptests::solved_once_tests
