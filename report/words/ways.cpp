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

std::vector<OperationOutcome> outcomes_of(const OperationTally& tally) {
  std::map<JudgedOutcome, OperationOutcome> by_outcome;
  for (const auto& [family, cell] : tally.families) {
    for (const auto& [outcome, counted] : cell.outcomes) {
      if (!counted.example) continue;
      OperationOutcome& sum = by_outcome[outcome];
      if (!sum.counted.example || shown_before(*counted.example, *sum.counted.example)) sum.family = family;
      sum.outcome = outcome;
      sum.counted.merge(counted);
      sum.families.push_back({family, both(counted.cases), cell.cases()});
    }
  }
  std::vector<OperationOutcome> outcomes;
  for (auto& [outcome, sum] : by_outcome) {
    std::stable_sort(sum.families.begin(), sum.families.end(),
                     [](const auto& a, const auto& b) { return a.cases > b.cases; });
    if (sum.families.size() > most_families) sum.families.resize(most_families);
    outcomes.push_back(std::move(sum));
  }
  std::stable_sort(outcomes.begin(), outcomes.end(), [](const OperationOutcome& a, const OperationOutcome& b) {
    const int rank_a = rank(a.outcome.verdict), rank_b = rank(b.outcome.verdict);
    return rank_a != rank_b ? rank_a < rank_b : a.counted.cases > b.counted.cases;
  });
  return outcomes;
}

std::string families_in_words(const OperationOutcome& outcome, std::size_t room) {
  std::string text;
  for (const auto& [name, cases, of] : outcome.families) {
    const std::string one = (text.empty() ? "" : ", ") + name + " " + grouped(cases) + " of " + grouped(of);
    if (!text.empty() && text.size() + one.size() > room) break;
    text += one;
  }
  return text;
}

std::string answer_in_words(const JudgedOutcome& outcome) {
  if (outcome.truth == outcome.answer) return "";
  return outcome.answer + (outcome.truth == "value" ? ", " : " where the truth is " + outcome.truth + ", ");
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
