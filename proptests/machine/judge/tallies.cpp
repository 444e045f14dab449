// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "audit/audit_run.h"
#include "audit/tally_json.h"
#include "proptests/catch.h"

namespace touchstone::audit {
namespace {

Tally audited(std::uint64_t seed, const char* operation = "orientation", std::uint64_t cases = 3000) {
  AuditOptions options;
  options.operations = {find_operation(operation)};
  options.cases = cases;
  options.seed = seed;
  return run_audit(options, false, [](const std::string&, std::uint64_t) {});
}

std::string refusal(Tally into, const Tally& other) {
  try {
    into.merge(other);
    return "merged";
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

}  // namespace

TEST_CASE("tallies: a cell counts verdicts, outcomes, touches, and keeps the smallest finding and the worst number") {
  Cell cell;
  count(cell, {{7, 7}}, {Verdict::agree, 0.5, "", 1}, "point", 0, nullptr);
  count(cell, {{5, 5}}, {Verdict::rounding, 0, "", 0}, "point", 1, "five");
  count(cell, {{1, 0}}, {Verdict::rounding, 0, "", 0}, "on", 2, "one");
  count(cell, {{123, 456}}, {Verdict::rounding, 900, "", 0}, "on", 3, "long");
  count(cell, {{9, 9}}, {Verdict::inexact, 40, "", 0}, "on", 4, nullptr);
  count(cell, {{9, 9}}, {Verdict::unsupported, 0, "", 0}, "on", 5, nullptr);
  CHECK(cell.touches_open == 0);
  // By rounding or without a valid answer no touch was treated in any way.
  count(cell, {{9, 9}}, {Verdict::rounding, 0, "", -1}, "on", 6, nullptr);
  count(cell, {{9, 9}}, {Verdict::invalid, 0, "", 1}, "on", 7, nullptr);
  count(cell, {{9, 9}}, {Verdict::convention, 0, "", -1}, "on", 8, nullptr);
  CHECK(cell.cases() == 9);
  CHECK(cell.count(Verdict::rounding) == 4);
  CHECK(cell.findings() == 6);
  CHECK(cell.outcomes == std::map<std::string, std::uint64_t>{{"point", 2}, {"on", 7}});
  CHECK(cell.touches_closed == 1);
  CHECK(cell.touches_open == 1);
  CHECK(cell.worst_ulps == 40);  // of right decisions only
  const auto& smallest = cell.smallest[static_cast<std::size_t>(Verdict::rounding)];
  REQUIRE(smallest);
  CHECK(smallest->question.numbers == std::vector<double>{1, 0});
  CHECK(smallest->index == 2);
  CHECK(smallest->answer == "one");
  CHECK_FALSE(cell.smallest[static_cast<std::size_t>(Verdict::agree)]);
  CHECK_FALSE(cell.smallest[static_cast<std::size_t>(Verdict::unsupported)]);
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
  CHECK(refusal(third, other) == "merged");
  other.grid.done = {1};
  CHECK(refusal(third, other) == "grid.done: every shard once (1 is there twice)");
  other.grid = {3, 4, {2}};
  CHECK(refusal(third, other) == "grid.shards: the same in every file");
}

TEST_CASE("tallies: merging cells in any order gives the same cell") {
  std::array<Cell, 3> parts;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Choices choices = Choices::seeded(seed_of(1, "cells", i));
    const auto verdict = static_cast<Verdict>(choices.below(verdict_count));
    const double x = static_cast<double>(choices.below(5)), y = static_cast<double>(choices.below(5));
    count(parts[choices.below(3)], {{x, y, 0, 0, 0, 0}, {}},
          {verdict, static_cast<double>(choices.below(100)), "", static_cast<int>(choices.below(3)) - 1},
          choices.below(2) == 1 ? "left" : "on", i, nullptr);
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
  count(early, {{1, 0}}, {Verdict::rounding, 0, "", 0}, "on", 3, "early");
  count(late, {{1, 0}}, {Verdict::rounding, 0, "", 0}, "on", 7, "late");
  for (auto [sum, other] : {std::pair{early, late}, {late, early}}) {
    sum.merge(other);
    const auto& kept = sum.smallest[static_cast<std::size_t>(Verdict::rounding)];
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
  CHECK(refusal(run, audited(2, "orientation", 300)) == "merged");
  Tally other = audited(2, "orientation", 300);
  other.declaration.engine = "another";
  CHECK(refusal(run, other) == "engine: the same in every file");
  other = audited(2, "orientation", 300);
  other.grid.size = 3;
  CHECK(refusal(run, other) == "grid.size: the same in every file");
}

TEST_CASE("tallies: a file of a tally reads back to the same bytes") {
  const std::string text = tally_json(audited(7, "segment_segment", 2000));
  CHECK(tally_json(read_tally(text)) == text);
}

TEST_CASE("tallies: a shard that the cut does not have is refused") {
  Tally tally = audited(1, "orientation", 10);
  const auto said = [&](std::vector<std::uint64_t> done) {
    tally.grid = {2, 3, std::move(done)};
    try {
      read_tally(tally_json(tally));
      return std::string("read");
    } catch (const InvalidInput& refused) {
      return std::string(refused.what());
    }
  };
  CHECK(said({1, 3}) == "read");
  CHECK(said({4}) == "grid.done[0]: one of the shards, counted from 1");
  CHECK(said({0}) == "grid.done[0]: one of the shards, counted from 1");
  CHECK(said({2, 2}) == "grid.done[1]: ascending");
}

}  // namespace touchstone::audit
