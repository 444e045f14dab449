// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_confusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "report/parts/html_parts.h"
#include "report/words/phrases.h"

namespace touchstone::report {
namespace {

constexpr std::size_t most_words = 12;

/// The answers in the order of the operation's enumerators; others come last.
std::vector<std::string> in_order(const Operation& operation, const std::vector<std::string>& found) {
  const std::vector<std::string> words = operation.words();
  std::vector<std::string> sorted = found;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const auto place = [&](const std::string& word) {
    return std::find(words.begin(), words.end(), word.substr(0, word.find('/'))) - words.begin();
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
  return sorted;
}

}  // namespace

std::string confusion_matrix(const Operation& operation, const Cell& total, const std::string& speaker_name) {
  const auto counts = total.confusion();
  std::vector<std::string> truths, answers;
  for (const auto& [pair, n] : counts) truths.push_back(pair.first), answers.push_back(pair.second);
  if (std::all_of(truths.begin(), truths.end(), [](const std::string& word) { return word == "value"; })) return "";
  truths = in_order(operation, truths);
  answers = in_order(operation, answers);
  if (truths.size() > most_words || answers.size() > most_words) return "";
  // A plain yes or no is not an enumerator of the truth: the verdicts tell which pairs are right.
  std::set<std::pair<std::string, std::string>> right_pairs;
  for (const auto& [outcome, count] : total.outcomes) {
    if (outcome.verdict == Verdict::agree || outcome.verdict == Verdict::inexact)
      right_pairs.emplace(outcome.truth, outcome.answer);
  }
  const auto refused = total.count(Verdict::convention) + total.count(Verdict::tolerance);
  std::string text =
      "<div class=\"card scroll\"><table class=\"confusion stack\"><thead><tr><th scope=\"col\">the truth is "
      "\u2026</th>";
  for (const std::string& answer : answers) text += "<th scope=\"col\">" + escaped(phrase(operation, answer)) + "</th>";
  text += "<th scope=\"col\">all</th></tr></thead><tbody>";
  for (const std::string& truth : truths) {
    std::uint64_t all = 0;
    text += "<tr><th scope=\"row\">" + escaped(phrase(operation, truth)) + "</th>";
    for (const std::string& answer : answers) {
      const auto found = counts.find({truth, answer});
      const ByRange n = found == counts.end() ? ByRange{} : found->second;
      all += both(n);
      const bool empty = both(n) == 0, right = truth == answer || right_pairs.count({truth, answer}) > 0;
      text +=
          fmt::format("<td class=\"{}\" data-label=\"answered: {}\">{}{}</td>",
                      empty   ? "none"
                      : right ? "right"
                              : "found",
                      escaped(phrase(operation, answer)), empty ? "\u2013" : grouped(both(n)),
                      empty || n[1] == 0 ? "" : "<small>" + (n[0] == 0 ? "none" : grouped(n[0])) + " ordinary</small>");
    }
    text += fmt::format("<td data-label=\"all\">{}</td></tr>", grouped(all));
  }
  return text + "</tbody></table><p class=\"small quiet\">Each number counts the cases of one truth to which " +
         escaped(speaker_name) + " gave one answer. Where it is shaded, the decision is right." +
         (refused > 0 ? " Other pairs may be allowed by the convention or the tolerance that the engine declares."
                      : "") +
         "</p></div>";
}

}  // namespace touchstone::report
