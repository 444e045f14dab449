// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_nearness.h"

#include <fmt/format.h>

#include "audit/counted.h"
#include "report/parts/html_parts.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

constexpr std::array<const char*, nearness_classes> class_words{"a tie: two numbers that it compares are equal",
                                                                "within its own rounding",
                                                                "1 to 10 times its rounding",
                                                                "10 to 100 times",
                                                                "100 to 10\u2074 times",
                                                                "10\u2074 to 10\u2076 times",
                                                                "10\u2076 to 10\u2079 times",
                                                                "10\u2079 times or more"};

std::string bars(const Recorded& recorded) {
  std::string rows;
  const std::uint64_t calls = recorded.calls();
  for (std::size_t c = 0; c < nearness_classes; ++c) {
    const std::uint64_t n = recorded.nearness[c];
    const double width = 100 * static_cast<double>(n) / static_cast<double>(calls);
    const std::string bar = n == 0 ? "" : fmt::format("<i style=\"width:{:.2f}%;--c:var(--ink)\"></i>", width);
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar-cell wide\"><div class=\"bar "
        "thin\">{}</div></td><td>{}</td><td>{}</td></tr>",
        class_words[c], bar, grouped(n), n == 0 ? "" : share(n, calls));
  }
  return "<table class=\"stack\"><thead><tr><th scope=\"col\">the formula was from another course</th><th "
         "scope=\"col\" "
         "class=\"text\"></th><th scope=\"col\">calls</th><th scope=\"col\">share</th></tr></thead><tbody>" +
         rows + "</tbody></table>";
}

std::string otherwise(const Recorded& recorded) {
  return fmt::format(
      "<p>Of {}, the textbook formula decides {} otherwise than the truth in double, and {} in float. In {} shapes "
      "only "
      "touch, so that open sets have another answer than closed ones.</p>",
      counted(recorded.calls(), "call"), grouped(recorded.in_double), grouped(recorded.in_float),
      grouped(recorded.as_open_sets));
}

std::string otherwise_head(const char* first) {
  return std::string("<table class=\"stack\"><thead><tr><th scope=\"col\">") + first +
         "</th><th scope=\"col\">calls</th><th scope=\"col\">ties</th><th scope=\"col\">within rounding</th><th "
         "scope=\"col\">the formula errs in double</th><th scope=\"col\">in float</th><th scope=\"col\">open sets "
         "answer otherwise</th></tr></thead><tbody>";
}

std::string otherwise_row(const std::string& name, const Recorded& here) {
  std::string text = "<tr><th scope=\"row\">" + name + "</th>";
  for (const std::uint64_t n :
       {here.calls(), here.nearness[0], here.nearness[1], here.in_double, here.in_float, here.as_open_sets})
    text += "<td>" + grouped(n) + "</td>";
  return text + "</tr>";
}

}  // namespace

std::string nearness_section(const OperationTally& tally) {
  const Recorded all = tally.total().recorded;
  if (all.calls() == 0) return "";
  std::string text =
      "<h2 id=\"nearness\">How near the calls were to another answer</h2><div class=\"card scroll\"><p>The textbook "
      "formula is run with a bound on how far rounding may carry each number. The nearest of its comparisons counts, "
      "in "
      "units of that bound: what is within it can be decided wrongly.</p>" +
      bars(all) + otherwise(all);
  if (tally.families.size() > 1) {
    text += otherwise_head("call site");
    for (const auto& [site, cell] : tally.families) text += otherwise_row(breakable(site), cell.recorded);
    text += "</tbody></table>";
  }
  return text + "</div>";
}

std::string nearness_of_all(const Tally& tally) {
  if (tally.logs.empty()) return "";
  std::string text =
      "<h2 id=\"nearness\">How near the calls were to another answer</h2><div class=\"card scroll\"><p>A call is near "
      "where a comparison of the textbook formula is a tie, or within the formula's own rounding. The page of each "
      "operation shows how far the others are.</p>" +
      otherwise_head("operation");
  for (const OperationTally& operation : tally.operations) {
    const Recorded all = operation.total().recorded;
    const std::string name = escaped(operation.operation);
    if (all.calls() > 0)
      text += otherwise_row("<a href=\"" + name + ".html#nearness\">" + breakable(operation.operation) + "</a>", all);
  }
  return text + "</tbody></table></div>";
}

}  // namespace touchstone::report
