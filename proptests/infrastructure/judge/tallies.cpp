// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "audit/counting/audit_run.h"
#include "audit/counting/generic.h"
#include "audit/counting/tally_json.h"
#include "proptests/catch.h"
#include "proptests/refusal.h"
#include "proptests/uses.h"

namespace touchstone::proptests::tallies_tests {
namespace {

Tally audited(std::uint64_t seed, const char* operation = "orientation", std::uint64_t cases = 3000) {
  AuditOptions options;
  options.operations = {find_operation(operation)};
  options.cases = cases;
  options.seed = seed;
  return run_audit(options, false, [](const std::string&, std::uint64_t) {});
}

/// Four numbers, the last two a point.
const Operation& line = *find_operation("explicit_line");

std::string refusal(Tally into, const Tally& other) {
  return refusal_of([&] { into.merge(other); });
}

}  // namespace

TEST_CASE("tallies: a finding about a number keeps it in the file, and says how a touch was treated") {
  Cell cell;
  Judgement judgement{Verdict::rounding, 1e7, "", 1};
  judgement.number = OffNumber{0.25, -1.5};
  judgement.said = "on";
  count(cell, {line, {{7, 0, 0, 0}}, "on", 0}, judgement, "said");
  CHECK(cell.touches_closed == 1);
  CHECK(cell.worst_ulps == 1e7);
  Tally tally;
  tally.operations.push_back({"explicit_line", {{"grid", cell}}});
  const Cell again = read_tally(tally_json(tally)).operations.at(0).families.at(0).second;
  REQUIRE(again.example(Verdict::rounding)->judgement.number);
  CHECK(again.example(Verdict::rounding)->judgement.number->exact == 0.25);
  CHECK(again.example(Verdict::rounding)->judgement.number->answered == -1.5);
}

TEST_CASE("tallies: a cell counts verdicts, truths, touches, and keeps the smallest finding and the worst number") {
  Cell cell;
  count(cell, {line, {{7, 0, 0, 0}}, "point", 0}, {Verdict::agree, 0.5, "", 1});
  count(cell, {line, {{5, 5, 0, 0}}, "point", 1}, {Verdict::rounding, 0, "", 0}, "five");
  count(cell, {line, {{1, 0, 0, 0}}, "on", 2}, {Verdict::rounding, 0, "", 0}, "one");
  count(cell, {line, {{123, 456, 0, 0}}, "on", 3}, {Verdict::rounding, 900, "", 0}, "long");
  count(cell, {line, {{9, 9, 0, 0}}, "on", 4}, {Verdict::inexact, 40, "", 0});
  count(cell, {line, {{9, 9, 0, 0}}, "on", 5}, {Verdict::unsupported, 0, "", 0});
  CHECK(cell.touches_open == 0);
  // By rounding or without a valid answer no touch was treated in any way.
  count(cell, {line, {{9, 9, 0, 0}}, "on", 6}, {Verdict::rounding, 0, "", -1});
  count(cell, {line, {{9, 9, 0, 0}}, "on", 7}, {Verdict::invalid, 0, "", 1});
  count(cell, {line, {{9, 9, 0, 0}}, "on", 8}, {Verdict::convention, 0, "", -1});
  CHECK(cell.cases() == 9);
  CHECK(cell.answered() == 8);
  CHECK(cell.count(Verdict::rounding) == 4);
  CHECK(cell.findings() == 6);
  CHECK(cell.wrong() == 5);
  CHECK(cell.truths() == std::map<std::string, std::uint64_t>{{"point", 2}, {"on", 7}});
  CHECK(cell.touches_closed == 1);
  CHECK(cell.touches_open == 1);
  CHECK(cell.worst_ulps == 40);  // of right decisions only
  const Finding* smallest = cell.example(Verdict::rounding);
  REQUIRE(smallest);
  CHECK(smallest->question.numbers == std::vector<double>{1, 0, 0, 0});
  CHECK(smallest->index == 2);
  CHECK(smallest->answer == "one");
  CHECK(cell.example(Verdict::agree) == nullptr);
  CHECK(cell.example(Verdict::unsupported) == nullptr);
}

TEST_CASE("tallies: every way of answering is counted apart, and has an example of its own") {
  Cell cell;
  const auto add = [&](Verdict verdict, const char* truth, const char* said, double number, std::uint64_t index) {
    Judgement judgement;
    judgement.verdict = verdict;
    judgement.said = said;
    count(cell, {line, {{number, 0, 0, 0}}, truth, index}, judgement);
  };
  add(Verdict::agree, "on", "on", 1, 0);
  add(Verdict::algorithm, "on", "above", 2, 1);
  add(Verdict::algorithm, "on", "above", 3, 2);
  add(Verdict::algorithm, "on", "below", 4, 3);
  add(Verdict::rounding, "on", "below", 5, 4);
  add(Verdict::algorithm, "above", "below", 6, 5);
  add(Verdict::invalid, "above", "", 7, 6);
  add(Verdict::unsupported, "above", "", 8, 7);
  CHECK(cell.outcomes.size() == 7);
  const OutcomeCount& twice = cell.outcomes.at({Verdict::algorithm, "on", "above"});
  CHECK(twice.cases == ByRange{2, 0});
  CHECK(twice.example->index == 1);
  CHECK(cell.outcomes.at({Verdict::algorithm, "on", "below"}).example->index == 3);
  CHECK(cell.outcomes.at({Verdict::rounding, "on", "below"}).example->index == 4);
  CHECK(cell.outcomes.at({Verdict::invalid, "above", no_valid_answer}).example->index == 6);
  CHECK_FALSE(cell.outcomes.at({Verdict::unsupported, "above", no_answer}).example);
  CHECK_FALSE(cell.outcomes.at({Verdict::agree, "on", "on"}).example);
  const auto confusion = cell.confusion();
  CHECK(confusion.size() == 6);
  CHECK(confusion.at({"on", "below"}) == ByRange{2, 0});  // by rounding and by algorithm
  CHECK(confusion.at({"on", "on"}) == ByRange{1, 0});
}

TEST_CASE("tallies: a question is of ordinary size if each of its numbers is 0 or within the limits, ends included") {
  const auto range = [](double number, const Limits& limits = {}) {
    return name_of(range_of({{1, number, 0}}, limits));
  };
  for (const double number : {0.0, -0.0, 1.0, -5.0, 0x1p100, -0x1p100, 0x1p-100, -0x1p-100})
    CHECK(range(number) == std::string("ordinary"));
  for (const double number : {0x1.0000000000001p100, -0x1p101, 0x1.fffffffffffffp-101, -5e-324, 1e308})
    CHECK(range(number) == std::string("extreme"));
  CHECK(range(1e-3, {1e-3, 1e3}) == std::string("ordinary"));
  CHECK(range(1e-4, {1e-3, 1e3}) == std::string("extreme"));
  CHECK(range(1e4, {1e-3, 1e3}) == std::string("extreme"));
}

TEST_CASE("tallies: cases of ordinary size are counted apart, and of rounding what left the range") {
  Cell cell;
  Judgement cancelled, left_the_range, wrong;
  cancelled.verdict = left_the_range.verdict = Verdict::rounding;
  cancelled.said = left_the_range.said = wrong.said = "on";
  left_the_range.out_of_range = true;
  wrong.verdict = Verdict::algorithm;
  count(cell, {line, {{1, 0, 0, 0}}, "above", 0}, cancelled);
  count(cell, {line, {{1, 0, 0, 1}}, "above", 1}, cancelled);
  count(cell, {line, {{1, 1e200, 0, 0}}, "above", 2}, cancelled);
  count(cell, {line, {{1e200, 1e200, 0, 0}}, "above", 3}, left_the_range);
  count(cell, {line, {{1, 5, 0, 0}}, "above", 4}, left_the_range);
  count(cell, {line, {{1e-200, 5, 0, 0}}, "above", 5}, wrong);
  CHECK(cell.cases(Range::ordinary) == 3);
  CHECK(cell.cases(Range::extreme) == 3);
  CHECK(cell.count(Verdict::rounding, Range::ordinary) == 3);
  CHECK(cell.count(Verdict::algorithm, Range::extreme) == 1);
  CHECK(cell.findings(Range::ordinary) == 3);
  CHECK(cell.cancellation() == ByRange{2, 1});
  CHECK(cell.out_of_range() == ByRange{1, 1});
}

TEST_CASE("tallies: examples are ordinary before extreme, then generic before degenerate, then small") {
  const auto judged_as = [](bool degenerate) {
    Judgement judgement;
    judgement.verdict = Verdict::rounding;
    judgement.degenerate = degenerate;
    return judgement;
  };
  // Each is a better example than those before it, though larger or later.
  const std::vector<std::pair<Question, bool>> better{{{{1e300, 0, 0, 0}}, true},  {{{1e300, 0, 0, 7}}, false},
                                                      {{{1, 1, 0, 0}}, true},      {{{1, 0, 0, 0}}, true},
                                                      {{{123, 456, 0, 0}}, false}, {{{12, 0, 0, 0}}, false}};
  Cell forwards, backwards;
  for (std::size_t i = 0; i < better.size(); ++i) {
    count(forwards, {line, better[i].first, "on", i}, judged_as(better[i].second));
    CHECK(forwards.example(Verdict::rounding)->index == i);
    const std::size_t j = better.size() - 1 - i;
    count(backwards, {line, better[j].first, "on", j}, judged_as(better[j].second));
    CHECK(backwards.example(Verdict::rounding)->index == better.size() - 1);
  }
}

TEST_CASE("tallies: points are in general position if no three are on one line, and two not equal") {
  const auto general = [](const char* operation, const char* question) {
    const Operation& asked = *find_operation(operation);
    return in_general_position(asked, asked.parse(parse_line(question)));
  };
  CHECK(general("segment_segment", R"({"a":[[0,0],[1,0]],"b":[[0,1],[3,4]]})"));
  CHECK_FALSE(general("segment_segment", R"({"a":[[0,0],[1,0]],"b":[[2,0],[3,4]]})"));
  CHECK_FALSE(general("segment_segment", R"({"a":[[1,0],[1,0]],"b":[[2,1],[3,4]]})"));
  CHECK_FALSE(general("segment_segment", R"({"a":[[0,0],[0.1,0.1]],"b":[[0.3,0.3],[3,4]]})"));
  // A ray from (0, 0) through (0.1, 0.3) misses (0.3, 0.9) by a little: 0.1 and 0.3 are doubles.
  CHECK(general("orientation", R"({"p0":[0,0],"p1":[0.1,0.3],"p":[0.3,0.9]})"));
  CHECK_FALSE(general("point_in_polygon", R"({"polygon":[[0,0],[4,0],[4,4]],"point":[2,2]})"));
  CHECK(general("point_in_polygon", R"({"polygon":[[0,0],[4,0],[4,4]],"point":[2,1]})"));
  // In space: the shadow on z = 0 alone is one line.
  CHECK(general("polygon_normal", R"({"polygon":[[0,0,0],[1,1,0],[2,2,1]]})"));
  CHECK_FALSE(general("polygon_normal", R"({"polygon":[[0,0,0],[1,1,1],[2,2,2],[5,0,0]]})"));
  // Directions are no points.
  CHECK(general("line_point_at", R"({"line":{"origin":[0,0],"direction":[0,0]},"t":1})"));
}

TEST_CASE("tallies: degenerate features are counted") {
  const auto features = [](const char* operation, const char* question) {
    const Operation& asked = *find_operation(operation);
    return degenerate_features(asked, asked.parse(parse_line(question)), false);
  };
  CHECK(features("segment_segment", R"({"a":[[0,0],[1,0]],"b":[[0,1],[3,4]]})") == 0);
  // Equal ends, which are on a line with any third point.
  CHECK(features("segment_segment", R"({"a":[[1,0],[1,0]],"b":[[2,1],[3,4]]})") == 2);
  CHECK(features("sphere_sphere", R"({"a":{"center":[0,0],"radius":1},"b":{"center":[3,0],"radius":1}})") == 0);
  CHECK(features("sphere_sphere", R"({"a":{"center":[0,0],"radius":0},"b":{"center":[3,0],"radius":0}})") == 2);
  // Two radii, equal balls, centers in one place.
  CHECK(features("sphere_sphere", R"({"a":{"center":[0,0],"radius":0},"b":{"center":[0,0],"radius":0}})") == 4);
  CHECK(features("ray_aabb", R"({"ray":{"origin":[5,7],"direction":[1,0]},"aabb":{"min":[0,1],"max":[2,3]}})") == 0);
  CHECK(features("ray_aabb", R"({"ray":{"origin":[5,7],"direction":[1,0]},"aabb":{"min":[0,1],"max":[2,1]}})") == 1);
  CHECK(features("line_point_at", R"({"line":{"origin":[0,1],"direction":[0,0]},"t":1})") == 1);
  CHECK(features("momentum", R"({"bodies":[]})") == 1);
  const Operation& line = *find_operation("orientation");
  CHECK(degenerate_features(line, line.parse(parse_line(R"({"p0":[0,0],"p1":[0.1,0.3],"p":[0.3,0.9]})")), true) == 1);
}

TEST_CASE("tallies: a direction with a component of 0, of a ray or from end to end of a segment") {
  const auto on_axis = [](const char* operation, const char* question) {
    const Operation& asked = *find_operation(operation);
    return has_direction_on_axis(asked, asked.parse(parse_line(question)));
  };
  CHECK(on_axis("ray_aabb", R"({"ray":{"origin":[5,7],"direction":[1,0]},"aabb":{"min":[0,1],"max":[2,3]}})"));
  CHECK_FALSE(on_axis("ray_aabb", R"({"ray":{"origin":[5,7],"direction":[1,2]},"aabb":{"min":[0,1],"max":[0,3]}})"));
  CHECK(on_axis("segment_aabb", R"({"segment":[[5,7],[5,8]],"aabb":{"min":[0,1],"max":[2,3]}})"));
  CHECK_FALSE(on_axis("segment_aabb", R"({"segment":[[5,7],[6,8]],"aabb":{"min":[0,1],"max":[0,3]}})"));
}

TEST_CASE("tallies: smaller is a total order, fewest digits first") {
  const std::vector<Question> ascending{{{0, 0}},  {{0, 1}},    {{1, 0}},     {{0, -1}},   {{1, 1}},
                                        {{12, 0}}, {{0.25, 0}}, {{0.1, 0.1}}, {{1e10, 0}}, {{5e-324, 0}}};
  for (const Question& a : ascending) {
    CHECK_FALSE(smaller(a, a));
    for (const Question& b : ascending) {
      if (a == b) continue;
      CHECK(smaller(a, b) != smaller(b, a));
    }
  }
  CHECK(smaller({{0, 0}}, {{0, 1}}));
  CHECK(smaller({{0, 1}}, {{1, 0}}));
  CHECK(smaller({{1, 1}}, {{100, 0}}));
  CHECK(smaller({{0.1, 0}}, {{5e-324, 0}}));
  CHECK(smaller({{1e10, 0}}, {{1e300, 0}}));
}

TEST_CASE("tallies: refused cases add up, and cells of one shard or cut into other shards do not merge") {
  const Tally rays = audited(1, "ray_segment", 600);
  const Cell total = rays.operations[0].total();
  CHECK(total.refused > 0);
  CHECK(total.cases() + total.refused == 600);
  CHECK(rays.robust[0].total().refused == total.refused);
  Tally third = audited(1, "orientation", 300), other = third;
  third.grid = {3, 3, {1}}, other.grid = {3, 3, {2}};
  CHECK(refusal(third, other) == "accepted");
  other.grid.done = {1};
  CHECK(refusal(third, other) == "grid.done: duplicate shard 1");
  other.grid = {3, 4, {2}};
  CHECK(refusal(third, other) == "grid.shards: the same in every file");
}

TEST_CASE("tallies: merging cells in any order gives the same cell") {
  std::array<Cell, 3> parts;
  for (std::uint64_t i = 0; i < 60; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(1, "cells", i));
    Judgement judgement;
    judgement.verdict = static_cast<Verdict>(draws.below(verdict_count));
    const double x = static_cast<double>(draws.below(5)), y = static_cast<double>(draws.below(5));
    const double size = draws.below(2) == 1 ? 1e200 : 1;
    Cell& part = parts[draws.below(3)];
    judgement.ulps = static_cast<double>(draws.below(100));
    judgement.touch_reading = static_cast<int>(draws.below(3)) - 1;
    judgement.said = draws.below(2) == 1 ? "right" : "on";
    judgement.out_of_range = draws.below(2) == 1;
    judgement.degenerate = draws.below(2) == 1;
    const std::string truth = draws.below(2) == 1 ? "left" : "on";
    count(part, {*find_operation("orientation"), {{x * size, y, 0, 1, 2, 5}}, truth, i}, judgement);
  }
  std::array<int, 3> order{0, 1, 2};
  std::string first;
  do {
    Cell sum;
    for (const int part : order) sum.merge(parts[static_cast<std::size_t>(part)]);
    CHECK(sum.cases() == 60);
    Tally tally;
    tally.operations.push_back({"orientation", {{"grid", sum}}});
    const std::string text = tally_json(tally);
    if (first.empty()) first = text;
    CHECK(text == first);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("tallies: of one finding counted twice the earlier case is kept, counted or merged") {
  Cell early, late;
  count(early, {line, {{1, 0, 0, 0}}, "on", 3}, {Verdict::rounding, 0, "", 0}, "early");
  count(late, {line, {{1, 0, 0, 0}}, "on", 7}, {Verdict::rounding, 0, "", 0}, "late");
  for (auto [sum, other] : {std::pair{early, late}, {late, early}}) {
    sum.merge(other);
    const Finding* kept = sum.example(Verdict::rounding);
    REQUIRE(kept);
    CHECK(kept->index == 3);
    CHECK(kept->answer == "early");
  }
}

TEST_CASE("tallies: merging runs of three seeds in any order gives the same tally, which is their sum") {
  const std::array<Tally, 3> runs{audited(3), audited(1), audited(2)};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::string first;
  do {
    Tally sum = runs[order[0]];
    sum.merge(runs[order[1]]), sum.merge(runs[order[2]]);
    CHECK(sum.cases == 9000);
    CHECK(sum.seed == 1);
    const std::string text = tally_json(sum);
    if (first.empty()) first = text;
    CHECK(text == first);
    std::uint64_t asked = 0;
    for (const Tally& run : runs) asked += run.operations[0].total().cases();
    CHECK(sum.operations[0].total().cases() == asked);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("tallies: operations merged in any order stand in the catalogue's order") {
  Tally sum = audited(1, "orientation", 500);
  sum.merge(audited(1, "explicit_line", 500));
  REQUIRE(sum.operations.size() == 2);
  CHECK(sum.operations[0].operation == "explicit_line");
  CHECK(sum.operations[1].operation == "orientation");
}

TEST_CASE("tallies: what counts the same cases, and what is of another engine or grid, does not merge") {
  const Tally run = audited(1, "orientation", 300);
  CHECK(refusal(run, run) == "seed: different in files that count the same family");
  CHECK(refusal(run, audited(2, "orientation", 300)) == "accepted");
  Tally other = audited(2, "orientation", 300);
  other.declaration.engine = "another";
  CHECK(refusal(run, other) == "engine: the same in every file");
  other = audited(2, "orientation", 300);
  other.grid.size = 3;
  CHECK(refusal(run, other) == "grid.size: the same in every file");
  other = audited(2, "orientation", 300);
  other.limits.most = 1e6;
  CHECK(refusal(run, other) == "limits: the same in every file");
}

TEST_CASE("tallies: a file of a tally reads back to the same bytes") {
  const std::string text = tally_json(audited(7, "segment_segment", 2000));
  CHECK(tally_json(read_tally(text)) == text);
}

TEST_CASE("tallies: a file whose numbers do not add up, or whose words the operation does not have, is refused") {
  const Json whole = parse_line(tally_json(audited(1, "orientation", 600)));
  const auto said = [&](const std::string& pointer, const Json& value) {
    Json changed = whole;
    changed[Json::json_pointer("/operations/0/families/0" + pointer)] = value;
    return refusal_of([&] { read_tally(one_line(changed)); });
  };
  const std::string cell = "operations[0].families[0].";
  const Json& outcome = whole["operations"][0]["families"][0]["ways"][0];
  CHECK(said("/ways/0/truth", outcome["truth"]) == "accepted");
  CHECK(said("/ways/0/truth", "up") == cell + "ways[0].truth: enumerators of orientation");
  CHECK(said("/ways/0/answer", "up") == cell + "ways[0].answer: enumerators of orientation");
  CHECK(said("/ways/0/answer", "left/") == cell + "ways[0].answer: enumerators of orientation");
  CHECK_THAT(said("/ways/0/cases/ordinary", 999999), ContainsSubstring("sum of the outcomes"));
  CHECK_THAT(said("/ways/1", outcome), ContainsSubstring("duplicate outcome"));
  CHECK_THAT(said("/counts/agree", 999999), ContainsSubstring("counts.agree: sum of the outcomes"));
}

TEST_CASE("tallies: a shard that the cut does not have is refused") {
  Tally tally = audited(1, "orientation", 10);
  const auto said = [&](std::vector<std::uint64_t> done) {
    tally.grid = {2, 3, std::move(done)};
    return refusal_of([&] { read_tally(tally_json(tally)); });
  };
  CHECK(said({1, 3}) == "accepted");
  CHECK(said({4}) == "grid.done[0]: one of the shards, counted from 1");
  CHECK(said({0}) == "grid.done[0]: one of the shards, counted from 1");
  CHECK(said({2, 2}) == "grid.done[1]: ascending");
}

}  // namespace touchstone::proptests::tallies_tests
