// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "audit/counting/audit_run.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/contract.h"
#include "report/pages/deck_page.h"
#include "report/parts/html_parts.h"

/// The deck as one page.
namespace touchstone::proptests::deck_tests {
namespace {

/// Orientation failed once, aabb_aabb was right.
Tally tally() {
  Cell wrong, right;
  right.outcomes[{Verdict::agree, "apart", "apart"}].cases = {4, 0};
  OutcomeCount& outcome = wrong.outcomes[{Verdict::rounding, "right", "on"}];
  outcome.cases = {1, 0};
  Finding found;
  found.question = Question{{0, 0, 2, 0, 1, -1}, {}};
  found.judgement.verdict = Verdict::rounding;
  found.answer = {{"side", "on"}};
  outcome.example = found;
  Tally tally;
  tally.declaration = reference_declaration();
  tally.operations = {{"orientation", {{"collinear", wrong}}}, {"aabb_aabb", {{"grid", right}}}};
  return tally;
}

/// From a section's opening to its end.
std::string section_of(const std::string& page, const std::string& pages) {
  const std::size_t begun = page.find("id=\"p" + pages + "\"");
  REQUIRE(begun != std::string::npos);
  return page.substr(begun, page.find(" id=\"", begun + 5) - begun);
}

}  // namespace

TEST_CASE("deck: each section has its idea, formula and figure, what broke it, and its scene, where there are such") {
  const std::string page =
      deck_page(tally(), {{"domino_row", {"A row of boxes", "The first is pushed.", Json::object()}}});
  const std::string sides = section_of(page, "16-17"), boxes = section_of(page, "45-47");
  CHECK_THAT(sides, ContainsSubstring("<h2>Which side of a line</h2>") && ContainsSubstring("<math display") &&
                        ContainsSubstring("data-drag=\"&quot;orientation&quot;\"") &&
                        ContainsSubstring("The case that breaks it") &&
                        ContainsSubstring("Truth:</b> right of the line"));
  CHECK(sides.find(player_opening) == std::string::npos);
  CHECK_THAT(boxes, ContainsSubstring("None of 4 hard cases breaks the formulas of this page.") &&
                        ContainsSubstring("In motion: A row of boxes") && ContainsSubstring(player_opening));
  // Without a figure to drag, a right case.
  CHECK_THAT(section_of(page, "21"), ContainsSubstring("right-case") && !ContainsSubstring("data-drag="));
}

TEST_CASE("deck: what no page asks, by its contract, stands at the end, and nothing else does") {
  const std::string page = deck_page({}, {}), beside = page.substr(page.find("id=\"beside\""));
  for (const Operation* operation : all_operations()) {
    INFO(operation->name());
    const bool listed = beside.find("<b>" + breakable(operation->name()) + "</b>") != std::string::npos;
    const std::vector<std::string> contract = contract_of(operation->name());
    const bool unasked = std::any_of(contract.begin(), contract.end(), [](const std::string& paragraph) {
      return paragraph.starts_with("No page of the deck asks this.");
    });
    CHECK(listed == unasked);
  }
  CHECK(page.find("breaks the formulas") == std::string::npos);  // nothing was asked
}

}  // namespace touchstone::proptests::deck_tests
