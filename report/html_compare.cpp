// SPDX-License-Identifier: Apache-2.0
#include "report/html_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/html_parts.h"
#include "report/wording.h"

namespace touchstone::audit {
namespace {

struct Pair {
  std::string name;
  std::string link;  ///< empty: none
  Cell before, after;
};

double rate(const Cell& cell) {
  return cell.answered() == 0 ? 0 : static_cast<double>(cell.wrong()) / static_cast<double>(cell.answered());
}
double change(const Pair& pair) { return rate(pair.after) - rate(pair.before); }

const OperationTally* find(const std::vector<OperationTally>& tallies, const std::string& name) {
  const auto found = std::find_if(tallies.begin(), tallies.end(), [&](const auto& t) { return t.operation == name; });
  return found == tallies.end() ? nullptr : &*found;
}

std::string wrong_in_words(const Cell& cell) {
  return grouped(cell.wrong()) + " of " + grouped(cell.answered()) + " (" + share(cell.wrong(), cell.answered()) + ")";
}

/// "fewer", "more": what happened to the share of wrong answers.
const char* verdict_on(const Pair& pair) {
  const double by = change(pair);
  return by < 0   ? pair.after.wrong() == 0 ? "fixed" : "fewer"
         : by > 0 ? pair.before.wrong() == 0 ? "new" : "more"
                  : "same";
}

std::string row(const Pair& pair, bool total) {
  const std::string name =
      pair.link.empty() ? breakable(pair.name) : "<a href=\"" + pair.link + "\">" + breakable(pair.name) + "</a>";
  return fmt::format(
      "<tr{}><th scope=\"row\">{}</th><td data-label=\"wrong before\">{}</td><td data-label=\"wrong now\">{}</td>"
      "<td data-label=\"inexact before, now\">{}, {}</td><td data-label=\"change\" class=\"{}\">{}</td></tr>",
      total ? " class=\"total\"" : "", name, wrong_in_words(pair.before), wrong_in_words(pair.after),
      grouped(pair.before.count(Verdict::inexact)), grouped(pair.after.count(Verdict::inexact)),
      change(pair) > 0 ? "found" : "", verdict_on(pair));
}

std::string table(const std::string& first, const std::vector<Pair>& pairs, const Pair& total) {
  std::string text =
      "<div class=\"card scroll\"><table class=\"stack\"><thead><tr><th scope=\"col\">" + first +
      "</th><th scope=\"col\">wrong before</th><th scope=\"col\">wrong now</th><th scope=\"col\">inexact before, now"
      "</th><th scope=\"col\">change</th></tr></thead><tbody>";
  for (const Pair& pair : pairs) text += row(pair, false);
  return text + row(total, true) + "</tbody></table></div>";
}

std::string heading(const Tally& before, const Tally& after) {
  std::string text = "<h2>Before and now</h2><p class=\"quiet\">Before: " + escaped(subject(before.declaration)) +
                     ". Now: " + escaped(subject(after.declaration)) + ".";
  if (before.seed != after.seed || before.cases != after.cases || !(before.limits == after.limits)) {
    text += " The two were not asked the same questions: " + counted(before.cases, "case") + " and seed " +
            std::to_string(before.seed) + " before, " + counted(after.cases, "case") + " and seed " +
            std::to_string(after.seed) + " now.";
  }
  return text + "</p>";
}

}  // namespace

std::string comparison(const Tally& before, const Tally& after) {
  std::vector<Pair> pairs;
  Pair total{"all of these", "", {}, {}};
  std::string alone;
  for (const OperationTally& now : after.operations) {
    const OperationTally* then = find(before.operations, now.operation);
    if (then == nullptr) {
      alone += (alone.empty() ? "" : ", ") + now.operation;
      continue;
    }
    pairs.push_back({now.operation, escaped(now.operation) + ".html", then->total(), now.total()});
    total.before.merge(pairs.back().before);
    total.after.merge(pairs.back().after);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return std::fabs(change(a)) > std::fabs(change(b)); });
  if (pairs.empty()) return heading(before, after) + "<p>The two audits have no operation in common.</p>";
  return heading(before, after) + table("operation", pairs, total) +
         (alone.empty() ? "" : "<p class=\"small quiet\">Not in the earlier audit: " + escaped(alone) + ".</p>");
}

std::string comparison(const Tally& before, const Tally& after, const std::string& operation) {
  const OperationTally *then = find(before.operations, operation), *now = find(after.operations, operation);
  if (then == nullptr || now == nullptr) return "";
  std::vector<Pair> pairs;
  for (const auto& [family, cell] : now->families) {
    for (const auto& [earlier_family, earlier] : then->families) {
      const Pair pair{family, "", earlier, cell};
      const bool same = change(pair) == 0 && earlier.count(Verdict::inexact) == cell.count(Verdict::inexact);
      if (family == earlier_family && !same) pairs.push_back(pair);
    }
  }
  return heading(before, after) + table("family", pairs, {"all", "", then->total(), now->total()});
}

}  // namespace touchstone::audit
