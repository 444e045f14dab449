// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/parts/html_parts.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

struct Pair {
  std::string name;  ///< HTML
  Cell before, after;

  /// The change of the share of wrong answers.
  double change() const {
    const auto rate = [](const Cell& cell) {
      return static_cast<double>(cell.wrong()) / static_cast<double>(std::max<std::uint64_t>(cell.answered(), 1));
    };
    return rate(after) - rate(before);
  }
  const char* change_in_words() const {
    if (change() == 0) return "same";
    return change() < 0 ? after.wrong() == 0 ? "fixed" : "fewer" : before.wrong() == 0 ? "new" : "more";
  }
};

std::string row(const Pair& pair, const char* style) {
  const auto wrong = [](const Cell& cell) {
    return grouped(cell.wrong()) + " of " + grouped(cell.answered()) + " (" + share(cell.wrong(), cell.answered()) +
           ")";
  };
  return fmt::format(
      "<tr{}><th scope=\"row\">{}</th><td data-label=\"wrong before\">{}</td><td data-label=\"wrong now\">{}</td>"
      "<td data-label=\"inexact before, now\">{}, {}</td><td data-label=\"change\" class=\"{}\">{}</td></tr>",
      style, pair.name, wrong(pair.before), wrong(pair.after), grouped(pair.before.count(Verdict::inexact)),
      grouped(pair.after.count(Verdict::inexact)), pair.change() > 0 ? "found" : "", pair.change_in_words());
}

}  // namespace

std::string comparison(const Tally& before, const Tally& after, const std::string& operation) {
  std::vector<Pair> pairs;
  Pair total{operation.empty() ? "all of these" : "all", {}, {}};
  std::string alone;
  for (const OperationTally& now : after.operations) {
    if (!operation.empty() && now.operation != operation) continue;
    const auto then = std::find_if(before.operations.begin(), before.operations.end(),
                                   [&](const OperationTally& earlier) { return earlier.operation == now.operation; });
    if (then == before.operations.end()) alone += (alone.empty() ? "" : ", ") + now.operation;
    if (then == before.operations.end()) continue;
    const std::string link = "<a href=\"" + escaped(now.operation) + ".html\">" + breakable(now.operation) + "</a>";
    if (operation.empty()) pairs.push_back({link, then->total(), now.total()});
    for (const auto& [family, cell] : now.families) {
      for (const auto& [earlier_family, earlier] : then->families) {
        const Pair pair{breakable(family), earlier, cell};
        const bool same = pair.change() == 0 && earlier.count(Verdict::inexact) == cell.count(Verdict::inexact);
        if (!operation.empty() && family == earlier_family && !same) pairs.push_back(pair);
      }
    }
    total.before.merge(then->total()), total.after.merge(now.total());
  }
  if (!operation.empty() && total.before.cases() == 0) return "";
  std::string text = "<h2>Before and now</h2><p class=\"quiet\">Before: " + escaped(subject(before.declaration)) +
                     ". Now: " + escaped(subject(after.declaration)) + ".";
  if (before.seed != after.seed || before.cases != after.cases || before.by_cost != after.by_cost ||
      !(before.limits == after.limits)) {
    text += fmt::format(" The two were not asked the same questions: {} and seed {} before, {} and seed {} now.",
                        counted(before.cases, "case"), before.seed, counted(after.cases, "case"), after.seed);
  }
  if (total.before.cases() == 0) return text + "</p><p>The two audits have no operation in common.</p>";
  text += std::string("</p><div class=\"card scroll\"><table class=\"stack\"><thead><tr><th scope=\"col\">") +
          (operation.empty() ? "operation" : "family") +
          "</th><th scope=\"col\">wrong before</th><th scope=\"col\">wrong now</th><th scope=\"col\">inexact before, "
          "now</th><th scope=\"col\">change</th></tr></thead><tbody>";
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return std::fabs(a.change()) > std::fabs(b.change()); });
  for (const Pair& pair : pairs) text += row(pair, "");
  return text + row(total, " class=\"total\"") + "</tbody></table></div>" +
         (alone.empty() ? "" : "<p class=\"small quiet\">Not in the earlier audit: " + escaped(alone) + ".</p>");
}

}  // namespace touchstone::report
