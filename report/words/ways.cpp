// SPDX-License-Identifier: Apache-2.0
#include "report/words/ways.h"

#include <algorithm>
#include <map>

#include "audit/counted.h"

namespace touchstone::report {
namespace {

constexpr std::size_t most_families = 3;

int rank(Verdict verdict) { return !is_finding(verdict) ? 2 : verdict == Verdict::inexact ? 1 : 0; }

}  // namespace

std::vector<WayOfOperation> ways_of(const OperationTally& tally) {
  std::map<Way, WayOfOperation> by_way;
  for (const auto& [family, cell] : tally.families) {
    for (const auto& [way, counted] : cell.ways) {
      if (!counted.example) continue;
      WayOfOperation& sum = by_way[way];
      if (!sum.counted.example || shown_before(*counted.example, *sum.counted.example)) sum.family = family;
      sum.way = way;
      sum.counted.merge(counted);
      sum.families.push_back({family, both(counted.cases), cell.cases()});
    }
  }
  std::vector<WayOfOperation> ways;
  for (auto& [way, sum] : by_way) {
    std::stable_sort(sum.families.begin(), sum.families.end(),
                     [](const auto& a, const auto& b) { return a.cases > b.cases; });
    if (sum.families.size() > most_families) sum.families.resize(most_families);
    ways.push_back(std::move(sum));
  }
  std::stable_sort(ways.begin(), ways.end(), [](const WayOfOperation& a, const WayOfOperation& b) {
    const int rank_a = rank(a.way.verdict), rank_b = rank(b.way.verdict);
    return rank_a != rank_b ? rank_a < rank_b : a.counted.cases > b.counted.cases;
  });
  return ways;
}

std::string families_in_words(const WayOfOperation& way, std::size_t room) {
  std::string text;
  for (const auto& [name, cases, of] : way.families) {
    const std::string one = (text.empty() ? "" : ", ") + name + " " + grouped(cases) + " of " + grouped(of);
    if (!text.empty() && text.size() + one.size() > room) break;
    text += one;
  }
  return text;
}

std::string answer_in_words(const Way& way) {
  if (way.truth == way.answer) return "";
  return way.answer + (way.truth == "value" ? ", " : " where the truth is " + way.truth + ", ");
}

std::string wrapped(const std::string& prose, std::size_t indent) {
  std::string text, rest = prose;
  while (rest.size() > line_width - indent) {
    const std::size_t space = rest.rfind(' ', line_width - indent);
    if (space == std::string::npos) break;
    text += rest.substr(0, space) + "\n" + std::string(indent, ' ');
    rest.erase(0, space + 1);
  }
  return text + rest;
}

}  // namespace touchstone::report
