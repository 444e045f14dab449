// SPDX-License-Identifier: Apache-2.0
#include "report/screen/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "catalogue/codec/excerpt.h"
#include "report/screen/table.h"
#include "report/words/hints.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

constexpr std::size_t most_findings = 5, bar_width = 24;
/// The room for a question or an answer: after an indentation, and with its length if it is truncated.
constexpr std::size_t room_of_value = line_width - 24;

struct ScreenRow {
  const OperationTally* operation;
  Cell total;

  double part(std::uint64_t n) const {
    return total.answered() == 0 ? 0 : static_cast<double>(n) / static_cast<double>(total.answered());
  }
  double wrong() const { return part(total.wrong()); }
  double inexact() const { return part(total.count(Verdict::inexact)); }
  bool right() const { return total.findings() == 0 && total.answered() > 0; }
};

/// The worst first; equal ones in the deck's order.
std::vector<ScreenRow> rows_of(const Tally& tally) {
  std::vector<ScreenRow> rows;
  for (const OperationTally& operation : tally.operations) rows.push_back({&operation, operation.total()});
  std::stable_sort(rows.begin(), rows.end(), [](const ScreenRow& a, const ScreenRow& b) {
    return a.wrong() != b.wrong() ? a.wrong() > b.wrong() : a.inexact() > b.inexact();
  });
  return rows;
}

/// '#' for wrong answers, '+' for inexact ones; at least one for each kind that occurs.
std::string bar(const ScreenRow& row) {
  const auto cells = [](double part) {
    return part == 0 ? 0 : std::max<std::size_t>(1, static_cast<std::size_t>(part * bar_width));
  };
  const std::size_t wrong = cells(row.wrong()), inexact = std::min(cells(row.inexact()), bar_width - wrong);
  return std::string(wrong, '#') + std::string(inexact, '+') + std::string(bar_width - wrong - inexact, '.');
}

/// As many of the causes as fit on the line, the gravest first.
std::string line_of(const ScreenRow& row, std::size_t name_width) {
  const Cell& total = row.total;
  std::string line = fmt::format("{:<{}} {}{:>7} of {:<7}", row.operation->operation, name_width, bar(row),
                                 share(total.wrong(), total.answered()), grouped(total.answered()));
  std::string separator = " ";
  for (const Verdict verdict : {Verdict::algorithm, Verdict::rounding, Verdict::invalid, Verdict::inexact}) {
    const std::string cause = separator + grouped(total.count(verdict)) + " " + name_of(verdict);
    if (total.count(verdict) == 0 || line.size() + cause.size() > line_width) continue;
    line += cause;
    separator = ", ";
  }
  return line + "\n";
}

/// The names, broken into lines that begin with `head`; at most that many lines.
std::string named(const std::string& head, const std::vector<ScreenRow>& rows) {
  std::string names;
  for (const ScreenRow& row : rows) names += (names.empty() ? "" : ", ") + row.operation->operation;
  return rows.empty() ? "" : wrapped(head + names, 2) + "\n";
}

/// Ranks findings for display: first those of ordinary magnitude, then those not caused by rounding, then those with
/// few degenerate features, then those that fit on a line, then the most frequent among the operation's answers.
struct Telling {
  const OperationTally* operation;
  OperationOutcome shown;
  double frequency;

  bool fits() const {
    const Operation* known = find_operation(operation->operation);
    return known != nullptr && one_line(known->print(shown.counted.example->question)).size() <= room_of_value;
  }
  auto rank() const {
    const Finding& example = *shown.counted.example;
    const Verdict verdict = shown.outcome.verdict;
    const int cause = verdict == Verdict::algorithm ? 0 : verdict == Verdict::rounding ? 1 : 2;
    return std::tuple(example.range, cause, example.features, !fits(), -frequency);
  }
};
/// The highest-ranked findings: the first of each operation, and if there is more room the others.
std::vector<Telling> telling(const Tally& tally) {
  std::vector<Telling> found, others;
  const auto by_rank = [](const Telling& a, const Telling& b) { return a.rank() < b.rank(); };
  for (const OperationTally& operation : tally.operations) {
    const std::size_t before = others.size();
    const auto cases = static_cast<double>(std::max<std::uint64_t>(1, operation.total().answered()));
    for (OperationOutcome& shown : outcomes_of(operation)) {
      const double frequency = static_cast<double>(both(shown.counted.cases)) / cases;
      if (is_finding(shown.outcome.verdict)) others.push_back({&operation, std::move(shown), frequency});
    }
    if (others.size() == before) continue;
    const auto first = std::min_element(others.begin() + static_cast<std::ptrdiff_t>(before), others.end(), by_rank);
    found.push_back(std::move(*first));
    others.erase(first);
  }
  std::stable_sort(found.begin(), found.end(), by_rank);
  std::stable_sort(others.begin(), others.end(), by_rank);
  for (Telling& other : others)
    if (found.size() < most_findings) found.push_back(std::move(other));
  if (found.size() > most_findings) found.resize(most_findings);
  return found;
}

/// A value on a line of its own, truncated if there is a width.
std::string cut(const std::string& value, std::size_t width) {
  return "  " + (width == 0 ? value : excerpt(value, std::max(width, line_width / 2) - (line_width - room_of_value))) +
         "\n";
}

/// `hinted`: the hints on its operation have been printed.
std::string in_words(const Telling& one, const Tally& tally, const std::string& speaker_name, std::size_t width,
                     bool hinted) {
  const Finding& finding = *one.shown.counted.example;
  const Operation* operation = find_operation(one.operation->operation);
  const std::string head =
      fmt::format("{}, {}: {}{}:", one.operation->operation, name_of(one.shown.outcome.verdict),
                  answer_in_words(one.shown.outcome), counted(both(one.shown.counted.cases), "case"));
  const std::size_t left = line_width - std::min(head.size(), line_width);
  const std::string families = families_in_words(one.shown, left > 0 ? left - 1 : 0);
  std::string text = "\n" + head + (families.size() < left ? " " : "\n  ") + families + "\n";
  if (!operation) return text;
  text += cut(one_line(operation->print(finding.question)), width);
  const std::string truth = one_line(readable(finding.examination(*operation).truth(), 24, 6)),
                    answer = finding.answer.is_null() ? no_answer : one_line(readable(finding.answer, 24, 6)),
                    both_answers = "truth " + truth + ", " + speaker_name + " " + answer;
  // If the two do not fit on one line, each has its own, so that the answer is not truncated.
  if (both_answers.size() <= room_of_value) text += "  " + both_answers + "\n";
  else text += cut("truth " + truth, width) + cut(speaker_name + " " + answer, width);
  const std::string reason =
      wrapped(why(finding, operation, speaker_of(tally.declaration), tally.declaration.binary32), 2);
  text += "  " + reason.substr(0, reason.find('\n', reason.find('\n') + 1)) + "\n";
  if (hinted) return text;
  for (const std::string& hint : hints(*one.operation, tally.declaration)) text += "  " + wrapped(hint, 2) + "\n";
  return text;
}

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

std::string screen(const Tally& tally, const std::string& more, std::size_t width) {
  const std::vector<ScreenRow> rows = rows_of(tally);
  std::vector<ScreenRow> right, wrong, unanswered;
  std::size_t name_width = 0;
  for (const ScreenRow& row : rows) {
    (row.right() ? right : row.total.answered() == 0 ? unanswered : wrong).push_back(row);
    if (!row.right()) name_width = std::max(name_width, row.operation->operation.size());
  }
  const std::string speaker_name = speaker_of(tally.declaration) == Speaker::reference ? "formula" : "engine";
  std::string findings;
  std::set<const OperationTally*> hinted;
  for (const Telling& one : telling(tally))
    findings += in_words(one, tally, speaker_name, width, !hinted.insert(one.operation).second);
  const std::string tail = named("right in all answers: ", right) + named("never answered: ", unanswered) +
                           robust_line(tally) + findings + "\n" + wrapped(closing_sentence(tally), 0) + more;
  std::string text = heading(tally);
  const std::size_t used = lines_of(text) + lines_of(tail) + 2;
  const std::size_t room = used < screen_lines ? std::min(wrong.size(), screen_lines - used) : 0;
  if (room > 0)
    text += fmt::format("{:<{}} {:<{}} wrong of answers\n", "", name_width, "# wrong, + inexact", bar_width);
  for (std::size_t i = 0; i < room; ++i) text += line_of(wrong[i], name_width);
  if (room < wrong.size()) text += "and " + counted(wrong.size() - room, "operation") + " with fewer wrong answers\n";
  return text + tail;
}

}  // namespace touchstone::report
