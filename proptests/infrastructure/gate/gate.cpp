// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/gate.h"

#include "audit/counting/audit_run.h"
#include "audit/gate/baseline.h"
#include "audit/gate/junit.h"
#include "audit/gate/sarif.h"
#include "audit/gate/shown.h"
#include "program/runs/audit_gate.h"
#include "proptests/catch.h"
#include "proptests/golden.h"
#include "proptests/infrastructure/program/called.h"
#include "proptests/refusal.h"
#include "proptests/uses.h"

/// What makes an audit fail in CI, and the files that say so.
namespace touchstone::proptests::gate_tests {
namespace {

Judgement judged_as(Verdict verdict, const char* said = "left", bool out_of_range = false) {
  Judgement judgement;
  judgement.verdict = verdict;
  judgement.said = said;
  judgement.out_of_range = out_of_range;
  return judgement;
}

void add(Cell& cell, const Judgement& judgement, int times) {
  for (int i = 0; i < times; ++i)
    count(cell, {*find_operation("orientation"), {{0, 0, 1, 0, 0, 1}}, "on", cell.cases()}, judgement, "said <&>\x01");
}

/// 100 cases of one family: 90 right, and these.
Tally tally_of(int algorithm, int cancelled = 0, int out_of_range = 0, int inexact = 0) {
  Cell cell;
  add(cell, judged_as(Verdict::agree, "on"), 100 - algorithm - cancelled - out_of_range - inexact);
  add(cell, judged_as(Verdict::algorithm), algorithm);
  add(cell, judged_as(Verdict::rounding), cancelled);
  add(cell, judged_as(Verdict::rounding, "left", true), out_of_range);
  add(cell, judged_as(Verdict::inexact, "on"), inexact);
  Tally tally;
  tally.declaration.engine = "e <1>";
  tally.seed = 1;
  tally.operations.push_back({"orientation", {{"collinear", cell}}});
  return tally;
}

bool passes(const Tally& tally, const Gate& gate) { return held_against(tally, gate).passed(); }

Gate with_causes(const std::string& causes) {
  Gate gate;
  gate.causes = causes_named(causes);
  return gate;
}

}  // namespace

TEST_CASE("gate: a gate fails by the causes that it names, and by no other") {
  for (const auto& [tally, cause] : {std::pair{tally_of(3), "algorithm"},
                                     {tally_of(0, 3), "cancellation"},
                                     {tally_of(0, 0, 3), "out_of_range"},
                                     {tally_of(0, 0, 0, 3), "inexact"}}) {
    INFO(cause);
    CHECK_FALSE(passes(tally, {}));
    CHECK(passes(tally, with_causes("none")));
    for (const char* named : {"algorithm", "cancellation", "out_of_range", "inexact", "invalid", "convention"})
      CHECK(passes(tally, with_causes(named)) == (named != std::string(cause)));
  }
  CHECK_FALSE(passes(tally_of(0, 1), with_causes("rounding")));
  CHECK_FALSE(passes(tally_of(0, 0, 1), with_causes("rounding")));
  CHECK(passes(tally_of(1), with_causes("rounding,inexact")));
  CHECK(passes(tally_of(0), {}));
  CHECK_THAT(refusal_of([] { causes_named("algorithm,wrong"); }), StartsWith("\"wrong\": one of none, rounding, "));
  CHECK_THAT(refusal_of([] { causes_named("invald"); }), EndsWith("(did you mean \"invalid\"?)"));
}

TEST_CASE("gate: conventions, unsupported questions and tolerated ones fail only where they are named") {
  Tally tally = tally_of(0);
  Cell& cell = tally.operations[0].families[0].second;
  for (const Verdict verdict : {Verdict::convention, Verdict::tolerance, Verdict::unsupported}) {
    add(cell, judged_as(verdict), 1);
    CHECK(passes(tally, {}));
    CHECK_FALSE(passes(tally, with_causes(name_of(verdict))));
  }
  add(cell, judged_as(Verdict::invalid, ""), 1);
  CHECK_FALSE(passes(tally, {}));
}

TEST_CASE("gate: what was not asked, an inconsistent convention and a wrong answer of robust fail it") {
  Tally given_up = tally_of(0);
  given_up.operations[0].families[0].second.not_asked = 1;
  CHECK_FALSE(passes(given_up, {}));
  CHECK(passes(given_up, with_causes("algorithm")));
  Tally both_ways = tally_of(0);
  both_ways.operations[0].families[0].second.touches_closed = 5;
  both_ways.operations[0].families[0].second.touches_open = 5;
  CHECK_FALSE(passes(both_ways, {}));
  CHECK(passes(both_ways, with_causes("algorithm")));
  Gate known;
  known.baseline = baseline_of(both_ways, usual_causes());
  CHECK(passes(both_ways, known));
  const GateResult accepted_once = held_against(both_ways, known);
  REQUIRE(accepted_once.entries.size() == 1);
  CHECK(in_words(accepted_once.entries[0]) ==
        "inconsistent_convention: touches answered now as closed sets do, now as open sets do, known");
  Tally too_many = tally_of(0);
  too_many.operations[0].families[0].second.surplus = 3;
  too_many.operations[0].families[0].second.apart = 4;
  too_many.max_surplus = 0.5;
  CHECK(
      gate_in_words(too_many, held_against(too_many, {})) ==
      "gate: failed: 1 new finding\n  orientation: surplus: more listed beyond the truth than --max-surplus allows\n");
  Tally robust = tally_of(0);
  robust.robust = tally_of(1).operations;
  CHECK_FALSE(passes(robust, with_causes("none")));
}

TEST_CASE("gate: the same questions may be answered wrongly as often as a baseline says, and no more often") {
  Gate gate;
  gate.baseline = baseline_of(tally_of(3, 2), usual_causes());
  CHECK(passes(tally_of(3, 2), gate));
  CHECK(passes(tally_of(1), gate));
  CHECK_FALSE(passes(tally_of(4, 2), gate));
  CHECK_FALSE(passes(tally_of(3, 2, 1), gate));  // another cause
  Tally elsewhere = tally_of(3, 2);
  elsewhere.operations[0].families[0].first = "typed_on_line";
  CHECK_FALSE(passes(elsewhere, gate));
  Tally another = tally_of(3, 2);
  another.operations[0].operation = "segment_segment";
  CHECK_FALSE(passes(another, gate));
  CHECK(held_against(tally_of(3), gate).gone == 1);
  CHECK(held_against(another, gate).gone == 0);  // it was not asked
  const Tally one_more = tally_of(4, 2);
  CHECK(gate_in_words(one_more, held_against(one_more, gate)) ==
        "gate: failed: 1 new finding; known: 5\n  orientation, collinear: algorithm in 4 of 100 cases, known: 3\n"
        "    echo '{\"p0\":[0,0],\"p1\":[1,0],\"p\":[0,1]}' | touchstone ask orientation -\n");
}

TEST_CASE("gate: of other questions as many may be wrong as the rate lets expect, and three standard deviations more") {
  Baseline baseline;
  baseline.seed = 1;
  baseline.known.push_back({"orientation", "collinear", Cause::algorithm, 100, 1000});
  const auto most = [&](std::uint64_t cases, std::uint64_t seed) {
    return accepted({"orientation", "collinear", Cause::algorithm, cases, cases}, seed, baseline);
  };
  CHECK(most(1000, 1) == 100);
  CHECK(most(1000, 2) == 142);  // 100 + 3 sqrt(100 + 100) = 142.4
  CHECK(most(4000, 1) == 534);  // 400 + 3 sqrt(400 + 1600) = 534.2
  CHECK(most(100, 1) == 19);    // 10 + 3 sqrt(10 + 1) = 19.9
  CHECK(accepted({"orientation", "collinear", Cause::algorithm, 7, 1000}, 2, baseline) == 7);
  CHECK(accepted({"orientation", "collinear", Cause::inexact, 7, 1000}, 2, baseline) == 0);
}

TEST_CASE("gate: a rate is held against an operation's findings that are not known") {
  Gate gate;
  gate.max_rate = 0.05;
  CHECK(passes(tally_of(5), gate));
  CHECK_FALSE(passes(tally_of(6), gate));
  CHECK_FALSE(passes(tally_of(3, 3), gate));  // together
  gate.baseline = baseline_of(tally_of(3), usual_causes());
  CHECK(passes(tally_of(8), gate));
  CHECK_FALSE(passes(tally_of(9), gate));
}

TEST_CASE("gate: a baseline reads back, an entry a line, and what is none is refused by its field") {
  const Baseline baseline = baseline_of(tally_of(3, 2, 1), usual_causes());
  const std::string text = baseline_json(baseline);
  CHECK(std::count(text.begin(), text.end(), '\n') == 5);  // the head, three entries, the end
  CHECK(baseline_json(read_baseline(text)) == text);
  CHECK_THAT(text, ContainsSubstring(R"("cause":"algorithm","findings":3,"cases":100,"rate":0.03})"));
  CHECK(baseline_json(read_baseline(baseline_json({"e", 7, {}}))) == baseline_json({"e", 7, {}}));
  const auto said = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return refusal_of([&] { read_baseline(changed); });
  };
  CHECK(said("\"orientation\"", "\"orientate\"") == "known[0].operation: operation of the catalogue");
  CHECK_THAT(said("\"cancellation\"", "\"rounding\""), StartsWith("known[0].cause: one of cancellation, "));
  CHECK(said("\"findings\":2", "\"findings\":-2") == "known[0].findings: count");
  CHECK(said("\"findings\":2", "\"findings\":101") == "known[0].findings: no more than cases");
  CHECK(said("\"touchstone\":1", "\"touchstone\":2") == "touchstone: version 1");
  CHECK(said("\"kind\":\"baseline\"", "\"kind\":\"tally\"") == "kind: baseline");
  CHECK_THAT(refusal_of([] { read_baseline("{"); }), ContainsSubstring("not JSON"));
}

TEST_CASE("gate: JUnit's file has a case for each family, which fails where the gate does") {
  Tally tally = tally_of(3, 2);
  Cell silent;
  add(silent, judged_as(Verdict::unsupported, ""), 4);
  tally.operations[0].families.emplace_back("grid", silent);
  tally.operations[0].families.emplace_back("typed", tally_of(0).operations[0].families[0].second);
  Gate gate;
  gate.baseline = baseline_of(tally_of(0, 2), usual_causes());
  check_golden("gate/golden/new_and_known.xml", junit_xml(tally, held_against(tally, gate)));
  check_golden("gate/golden/passed.xml", junit_xml(tally_of(0), held_against(tally_of(0), {})));
}

TEST_CASE("gate: text in XML has no control characters and no bytes that are no UTF-8") {
  CHECK(xml_text("a<b>&\"'") == "a&lt;b&gt;&amp;&quot;&apos;");
  CHECK(xml_text("one\ntwo\n") == "one\ntwo\n");
  CHECK(xml_text("\x1b[2J") == "\\x1b[2J");
  CHECK(xml_text(std::string(1, '\0') + "\x02") == "\\x00\\x02");
  CHECK(xml_text("\xff") == "\\xff");
  CHECK(xml_text("").empty());
}

TEST_CASE("gate: the SARIF file has what version 2.1.0 requires, and says what is new") {
  const Tally tally = tally_of(3, 2);
  Gate gate;
  gate.baseline = baseline_of(tally_of(0, 2), usual_causes());
  const auto sarif = [](const Tally& audited, const Gate& held, const char* engine) {
    return parse_own_line(sarif_json(audited, held, held_against(audited, held), engine)).dump(1) + '\n';
  };
  check_golden("gate/golden/new_and_known.sarif", sarif(tally, gate, "src/engine.cpp"));
  CHECK_THAT(sarif(tally, {}, "engine"), !ContainsSubstring("baselineState"));
  check_golden("gate/golden/passed.sarif", sarif(tally_of(0), {}, "engine"));
}

TEST_CASE("gate: an interrupted audit leaves the baseline as it is") {
  const TextFile baseline("interrupted.json", "as it was");
  const auto after = [&](bool interrupted) {
    Tally tally = tally_of(3);
    tally.interrupted = interrupted;
    GateCommand command;
    command.write_baseline = baseline.path();
    std::ostringstream out;
    finish_gate(command, {}, tally, out);
    std::stringstream text;
    text << std::ifstream(baseline.path()).rdbuf();
    return text.str();
  };
  CHECK(after(true) == "as it was");
  CHECK(after(false) == baseline_json(baseline_of(tally_of(3), usual_causes())));
}

}  // namespace touchstone::proptests::gate_tests
