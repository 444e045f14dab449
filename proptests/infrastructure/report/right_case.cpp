// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/generic.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/html_finding.h"

namespace touchstone::proptests::right_case_tests {

TEST_CASE("right case: what findings are held against is rich, no empty list and nothing degenerate") {
  for (const char* const name : {"broad_phase", "all_pairs", "segment_segment", "sphere_sphere", "triangle_triangle"}) {
    const Operation& operation = *find_operation(name);
    const std::string card = report::right_case(operation);
    const std::string before = "<summary>The input as JSON</summary><code>";
    const std::size_t from = card.find(before);
    INFO(name << ": " << card.substr(0, 200));
    REQUIRE(from != std::string::npos);
    std::string input = card.substr(from + before.size());
    input.resize(input.find("</code>"));
    const auto replace_all = [&input](const std::string& text, const char* by) {
      for (std::size_t at; (at = input.find(text)) != std::string::npos;) input.replace(at, text.size(), by);
    };
    replace_all("&quot;", "\""), replace_all("<wbr>", "");
    const Question question = operation.parse(parse_line(input));
    CHECK(degenerate_features(operation, question, operation.examine(question)->degenerate()) == 0);
  }
}

}  // namespace touchstone::proptests::right_case_tests
