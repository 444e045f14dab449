// SPDX-License-Identifier: Apache-2.0
#include "report/screen/table.h"

#include <map>
#include <sstream>

#include "audit/counting/audit_run.h"
#include "audit/counting/tally_json.h"
#include "proptests/catch.h"
#include "proptests/golden.h"
#include "proptests/uses.h"

/// The table that an audit prints: its numbers add up.
namespace touchstone::proptests::table_tests {
namespace {

struct Line {
  std::string name;
  std::vector<std::uint64_t> cells;  ///< a dash is 0
};

/// The lines of the table whose last nine words are numbers or dashes.
std::vector<Line> rows_of(const std::string& text) {
  std::vector<Line> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    if (all.size() < 10) continue;
    Line row;
    bool numbers = true;
    for (std::size_t i = all.size() - 9; i < all.size(); ++i) {
      std::string digits = all[i] == "-" ? "0" : all[i];
      digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
      numbers = numbers && digits.find_first_not_of("0123456789") == std::string::npos;
      if (numbers) row.cells.push_back(std::stoull(digits));
    }
    if (!numbers) continue;
    for (std::size_t i = 0; i + 9 < all.size(); ++i) row.name += (i == 0 ? "" : " ") + all[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Of `rounding` alone: the number in the line of that name after row `from` of the text.
std::uint64_t only_number(const std::string& text, const std::string& name, std::size_t from) {
  const std::size_t at = text.find("\n  " + name + " ", from);
  REQUIRE(at != std::string::npos);
  std::string digits = text.substr(at + 3 + name.size(), text.find('\n', at + 1) - at - 3 - name.size());
  digits.erase(std::remove_if(digits.begin(), digits.end(), [](char c) { return c == ' ' || c == ','; }), digits.end());
  return digits == "-" ? 0 : std::stoull(digits);
}

Tally audited(const char* operations, bool ordinary_only = false, std::uint64_t seed = 1) {
  AuditOptions options;
  std::istringstream names(operations);
  for (std::string name; names >> name;) options.operations.push_back(find_operation(name));
  options.cases = 3000;
  options.ordinary_only = ordinary_only;
  options.seed = seed;
  return run_audit(options, false, [](const std::string&, std::uint64_t) {});
}

using Cells = std::vector<std::uint64_t>;
void add(const Cells& row, Cells& sum) {
  sum.resize(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) sum[i] += row[i];
}

Judgement judged_as(Verdict verdict, const char* said, bool out_of_range = false) {
  Judgement judgement;
  judgement.verdict = verdict;
  judgement.said = said;
  judgement.out_of_range = out_of_range;
  return judgement;
}

}  // namespace

TEST_CASE("table: verdicts add up to cases, families and sizes to their operation, operations to all") {
  const std::string text = text_table(audited("segment_segment orientation aabb_aabb"));
  const std::vector<Line> rows = rows_of(text);
  Cells operations, all;
  std::size_t families = 0;
  for (std::size_t i = 0; i < rows.size();) {
    INFO(rows[i].name);
    const Cells total = rows[i].cells;
    const bool is_sum = rows[i].name == "all";
    ++i;
    Cells by_size, by_family;
    for (; i < rows.size() && rows[i].name.find(" size") != std::string::npos; ++i) add(rows[i].cells, by_size);
    CHECK(by_size == total);
    for (; !is_sum && i < rows.size() && rows[i].name != "all" && !find_operation(rows[i].name); ++i, ++families)
      add(rows[i].cells, by_family);
    if (is_sum) {
      all = total;
    } else {
      CHECK(by_family == total);
      add(total, operations);
    }
  }
  CHECK(families == find_operation("segment_segment")->families().size() +
                        find_operation("orientation")->families().size() +
                        find_operation("aabb_aabb")->families().size());
  CHECK(operations == all);
  for (const Line& row : rows) {
    INFO(row.name);
    std::uint64_t verdicts = 0;
    for (std::size_t v = 1; v < row.cells.size(); ++v) verdicts += row.cells[v];
    CHECK(verdicts == row.cells[0]);
  }
  const std::size_t sum_line = text.find("\nall ");
  CHECK(only_number(text, "by cancellation", sum_line) + only_number(text, "by over- or underflow", sum_line) ==
        all[1 + static_cast<std::size_t>(Verdict::rounding)]);
}

TEST_CASE("table: files of audits that are merged add up in every row, and keep what was left out") {
  for (const bool ordinary_only : {false, true}) {
    const Tally first = audited("segment_segment", ordinary_only, 1),
                second = audited("segment_segment", ordinary_only, 2);
    Tally sum = read_tally(tally_json(first));
    sum.merge(read_tally(tally_json(second)));
    const std::string text = text_table(sum), text_a = text_table(first), text_b = text_table(second);
    const std::vector<Line> rows = rows_of(text), a = rows_of(text_a), b = rows_of(text_b);
    REQUIRE(rows.size() == a.size());
    REQUIRE(rows.size() == b.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      INFO(rows[i].name);
      CHECK(rows[i].name == a[i].name);
      Cells both = a[i].cells;
      add(b[i].cells, both);
      CHECK(rows[i].cells == both);
    }
    for (const char* kind : {"by cancellation", "by over- or underflow"}) {
      if (!ordinary_only)
        CHECK(only_number(text, kind, 0) == only_number(text_a, kind, 0) + only_number(text_b, kind, 0));
    }
    const auto left_out = [](const Tally& tally) { return tally.operations[0].total().left_out; };
    CHECK(left_out(sum) == left_out(first) + left_out(second));
    CHECK((left_out(sum) > 0) == ordinary_only);
  }
}

TEST_CASE("table: the closing sentence is the sum of its parts, ordinary and extreme, and of rounding both kinds") {
  Tally tally;
  Cell cell;
  const Operation& line = *find_operation("explicit_line");
  std::uint64_t index = 0;
  const auto add = [&](Judgement judgement, double number, int times) {
    for (int i = 0; i < times; ++i) count(cell, {line, {{number, 0, 0, 0}}, "on", index++}, judgement);
  };
  add(judged_as(Verdict::agree, "on"), 1, 10);
  add(judged_as(Verdict::agree, "on"), 1e200, 5);
  add(judged_as(Verdict::rounding, "above"), 1, 3);
  add(judged_as(Verdict::rounding, "above"), 1e200, 2);
  add(judged_as(Verdict::rounding, "above", true), 1e200, 4);
  add(judged_as(Verdict::algorithm, "below"), 1, 6);
  add(judged_as(Verdict::invalid, ""), 1e200, 1);
  add(judged_as(Verdict::inexact, "on"), 1, 7);
  add(judged_as(Verdict::unsupported, ""), 1, 2);
  tally.operations.push_back({"explicit_line", {{"grid", cell}}});
  check_golden("report/golden/closing_sentence.txt", text_table(tally));
}

TEST_CASE("table: where nothing is right of twenty answers or more, the connection is to be looked at first") {
  const auto says = [](std::uint64_t wrong, std::uint64_t inexact) {
    Cell cell;
    cell.outcomes[{Verdict::rounding, "on", "left"}].cases = {wrong, 0};
    cell.outcomes[{Verdict::unsupported, "on", "no answer"}].cases = {100, 0};
    if (inexact > 0) cell.outcomes[{Verdict::inexact, "on", "on"}].cases = {inexact, 0};
    Tally tally;
    tally.declaration.engine = "an engine";
    tally.operations.push_back({"orientation", {{"grid", cell}}});
    return text_table(tally).find("orientation: none of ") != std::string::npos;
  };
  CHECK(says(20, 0));
  CHECK_FALSE(says(19, 0));
  CHECK_FALSE(says(2000, 1));
}

TEST_CASE("table: an example for each way of answering, wrong ones before inexact ones, at most six") {
  Tally tally;
  Cell cell;
  const Operation& sides = *find_operation("orientation");
  std::uint64_t index = 0;
  const auto add = [&](Verdict verdict, const char* truth, const char* said, int times, double number = 1) {
    for (int i = 0; i < times; ++i)
      count(cell, {sides, {{0, 0, number, 0, 0, 1}}, truth, index++}, judged_as(verdict, said));
  };
  add(Verdict::inexact, "on", "on", 50);
  add(Verdict::algorithm, "on", "left", 2);
  add(Verdict::algorithm, "on", "right", 3);
  add(Verdict::algorithm, "left", "right", 9, 1e200);
  tally.operations.push_back({"orientation", {{"grid", cell}}});
  const std::string few = text_table(tally), summary = text_table(tally, Detail::operations);
  for (const char* said : {"left", "right"}) {
    for (const char* truth : {"left", "on", "right"}) add(Verdict::rounding, truth, said, 1);
  }
  tally.operations[0].families[0].second = cell;
  check_golden("report/golden/examples.txt", few + "\n====\n\n" + summary + "\n====\n\n" + text_table(tally));
}

TEST_CASE("table: a summary has a row for each operation and no family") {
  const Tally tally = audited("segment_segment orientation");
  const std::vector<Line> rows = rows_of(text_table(tally, Detail::operations));
  REQUIRE(rows.size() == 5);
  CHECK(rows[0].name == "segment_segment");
  CHECK(rows[1].name == "orientation");
  CHECK(rows[2].name == "all");
  CHECK(rows[0].cells[0] + rows[1].cells[0] == rows[2].cells[0]);
}

TEST_CASE("table: an audit of ordinary size alone says what was left out, and has no extreme cases") {
  const Tally all = audited("orientation"), ordinary = audited("orientation", true);
  const Cell whole = all.operations[0].total(), part = ordinary.operations[0].total();
  CHECK(part.cases(Range::extreme) == 0);
  CHECK(part.cases() == whole.cases(Range::ordinary));
  CHECK(part.left_out == whole.cases(Range::extreme));
  CHECK(part.count(Verdict::rounding) == whole.count(Verdict::rounding, Range::ordinary));
  const std::string text = text_table(ordinary);
  CHECK_THAT(text, ContainsSubstring(", ordinary size only\n") &&
                       ContainsSubstring("drawn but of extreme size, so not asked: ") &&
                       !ContainsSubstring("extreme size  "));
  CHECK_THAT(text_table(all), !ContainsSubstring("not asked"));
}

}  // namespace touchstone::proptests::table_tests
