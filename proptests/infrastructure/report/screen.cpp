// SPDX-License-Identifier: Apache-2.0
#include "report/screen/screen.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "audit/counting/audit_run.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/words/ways.h"

namespace touchstone::proptests::screen_tests {
namespace {

Tally audited(std::vector<const Operation*> operations, std::uint64_t cases) {
  AuditOptions options;
  options.operations = std::move(operations);
  options.cases = cases;
  return run_audit(options, false, [](const std::string&, std::uint64_t) {});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream from(text);
  for (std::string line; std::getline(from, line);) lines.push_back(line);
  return lines;
}

/// Rows have a bar in their second word.
bool is_row(const std::string& line) {
  std::istringstream words(line);
  std::string name, bar;
  words >> name >> bar;
  return find_operation(name) != nullptr && bar.size() == 24 && bar.find_first_not_of("#+.") == std::string::npos;
}

}  // namespace

TEST_CASE("screen: an audit of everything fits, and leaves no operation out") {
  const Tally tally = audited(catalogue::all_operations(), 60);
  const std::string text = screen(tally, "more\n");
  const std::vector<std::string> lines = lines_of(text);
  CHECK(lines.size() <= screen_lines);
  CHECK(lines.size() > screen_lines / 2);
  for (const std::string& line : lines) {
    INFO(line);
    CHECK(line.size() <= line_width);
  }
  CHECK(lines.back() == "more");
  std::size_t rows = 0, right = 0, fewer = 0;
  for (const OperationTally& operation : tally.operations)
    right += operation.total().findings() == 0 && operation.total().answered() > 0 ? 1 : 0;
  for (const std::string& line : lines) {
    rows += is_row(line) ? 1 : 0;
    if (line.starts_with("and ")) fewer = std::stoul(line.substr(4));
  }
  CHECK(rows > 10);
  std::set<std::string> findings;
  for (const std::string& line : lines) {
    const std::string name = line.substr(0, line.find(", "));
    if (find_operation(name) != nullptr && name != line) findings.insert(name);
  }
  CHECK(findings.size() == 5);
  CHECK(rows + right + fewer == tally.operations.size());
}

TEST_CASE("screen: the worst first, with what is wrong of the answers") {
  const auto of = [](const char* name) { return find_operation(name); };
  const Tally tally = audited({of("point_ground_plane"), of("segment_segment"), of("polygon_normal")}, 2000);
  std::vector<std::string> rows;
  for (const std::string& line : lines_of(screen(tally, "")))
    if (is_row(line)) rows.push_back(line.substr(0, line.find(' ')));
  std::vector<std::string> expected{"segment_segment", "polygon_normal"};
  const auto wrong = [&](std::size_t i) {
    const Cell cell = tally.operations[i].total();
    return static_cast<double>(cell.wrong()) / static_cast<double>(cell.answered());
  };
  if (wrong(2) > wrong(1)) std::swap(expected[0], expected[1]);
  CHECK(rows == expected);
  const std::string text = screen(tally, "");
  CHECK(text.find("right in all answers: point_ground_plane\n") != std::string::npos);
  const auto findings = [&text](const char* name) {
    return text.find("\n" + std::string(name) + ", ") != std::string::npos;
  };
  CHECK(findings("segment_segment"));
  CHECK(findings("polygon_normal"));
  CHECK(!findings("point_ground_plane"));
}

TEST_CASE("screen: a finding names the families that it is in, and nothing is cut where there is no width") {
  const Operation& operation = *find_operation("segment_segment");
  const Tally tally = audited({&operation}, 2000);
  const std::string narrow = screen(tally, "", 60), full = screen(tally, "", 0);
  std::size_t named = 0;
  for (const OperationOutcome& outcome : outcomes_of(tally.operations[0])) {
    CHECK(outcome.families.size() <= 3);
    std::uint64_t cases = 0;
    for (const auto& [name, wrong, of] : outcome.families) {
      CHECK(wrong <= of);
      cases += wrong;
    }
    CHECK(cases <= both(outcome.counted.cases));
    CHECK((outcome.families.size() == 3 || cases == both(outcome.counted.cases)));
    named += full.find(": " + families_in_words(outcome, 0)) != std::string::npos ? 1 : 0;
  }
  CHECK(named > 0);
  CHECK(narrow.find(" bytes)") != std::string::npos);
  CHECK(full.find(" bytes)") == std::string::npos);
}

}  // namespace touchstone::proptests::screen_tests
