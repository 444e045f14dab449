// SPDX-License-Identifier: Apache-2.0
#include "report/screen/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/engines/protocol.h"
#include "report/words/hints.h"
#include "report/words/ways.h"
#include "report/words/wording.h"

namespace touchstone::report {
namespace {

constexpr std::size_t columns = verdict_count + 1;

struct Row {
  std::string name;
  std::array<std::string, columns> cells;
};

std::string count_or_dash(std::uint64_t n) { return n == 0 ? "-" : grouped(n); }

Row row_of(const std::string& name, std::uint64_t cases, const std::array<std::uint64_t, verdict_count>& counts) {
  Row row{name, {}};
  row.cells[0] = grouped(cases);
  for (std::size_t v = 0; v < verdict_count; ++v) row.cells[v + 1] = count_or_dash(counts[v]);
  return row;
}
Row row_of(const std::string& name, const Cell& cell) { return row_of(name, cell.cases(), cell.counts()); }

Row row_of(const std::string& name, const Cell& cell, Range range) {
  std::array<std::uint64_t, verdict_count> counts{};
  for (std::size_t v = 0; v < verdict_count; ++v) counts[v] = cell.count(static_cast<Verdict>(v), range);
  return row_of(name, cell.cases(range), counts);
}

/// A row with only the count of `rounding`.
Row row_of_rounding(const std::string& name, std::uint64_t n) {
  Row row{name, {}};
  row.cells[1 + static_cast<std::size_t>(Verdict::rounding)] = count_or_dash(n);
  return row;
}

/// A total, by the magnitude of the questions, and its rounding by kind. The parts of each add up to it.
void add_total(const std::string& name, const Cell& cell, std::vector<Row>& rows) {
  rows.push_back(row_of(name, cell));
  if (cell.cases(Range::ordinary) > 0 && cell.cases(Range::extreme) > 0) {
    rows.push_back(row_of("  ordinary size", cell, Range::ordinary));
    rows.push_back(row_of("  extreme size", cell, Range::extreme));
  }
  const std::uint64_t out_of_range = both(cell.out_of_range());
  if (out_of_range == 0) return;
  rows.push_back(row_of_rounding("  by cancellation", both(cell.cancellation())));
  rows.push_back(row_of_rounding("  by over- or underflow", out_of_range));
}

Row header_row(bool recorded) {
  Row row{recorded ? "operation, call site" : "operation, family", {}};
  row.cells[0] = "cases";
  for (std::size_t v = 0; v < verdict_count; ++v) row.cells[v + 1] = verdict_names[v];
  return row;
}

/// Right-aligned columns as narrow as their content; a name too long for the remaining room has a line of its own.
std::string laid_out(const std::vector<Row>& rows) {
  std::array<std::size_t, columns> widths{};
  std::size_t longest = 0, cells = 0;
  for (const Row& row : rows) {
    longest = std::max(longest, row.name.size());
    for (std::size_t c = 0; c < columns; ++c) widths[c] = std::max(widths[c], row.cells[c].size() + 2);
  }
  for (const std::size_t width : widths) cells += width;
  const std::size_t left = std::max<std::size_t>(20, cells < line_width ? line_width - cells : 0);
  const std::size_t name_width = std::min(longest, left);
  std::string text;
  for (const Row& row : rows) {
    if (row.name.empty()) {
      text += "\n";
      continue;
    }
    text += row.name.size() > name_width ? row.name + "\n" + std::string(name_width, ' ')
                                         : fmt::format("{:<{}}", row.name, name_width);
    for (std::size_t c = 0; c < columns; ++c) text += fmt::format("{:>{}}", row.cells[c], widths[c]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

std::string counts(const Tally& tally, Detail detail) {
  std::vector<Row> rows{header_row(tally.repeat.recorded)};
  for (const OperationTally& operation : tally.operations) {
    const Cell total = operation.total();
    if (detail == Detail::operations) {
      rows.push_back(row_of(operation.operation, total));
      continue;
    }
    rows.push_back({});
    add_total(operation.operation, total, rows);
    if (total.count(Verdict::unsupported) == total.cases()) continue;  // the engine never answers it
    for (const auto& [family, cell] : operation.families) rows.push_back(row_of("  " + family, cell));
  }
  if (detail == Detail::all) rows.push_back({});
  const Cell sum = sum_of(tally.operations);
  add_total("all", sum, rows);
  std::string rules;
  for (const auto& [rule, n] : sum.rules) rules += (rules.empty() ? " (" : ", ") + rule + ": " + grouped(n);
  if (!rules.empty()) rules += ")";
  std::string notes =
      sum.refused == 0 ? "" : "drawn but outside the contract, so no cases: " + grouped(sum.refused) + rules + "\n";
  if (sum.left_out > 0) notes += "drawn but of extreme size, so not asked: " + grouped(sum.left_out) + "\n";
  for (const OperationTally& operation : tally.operations) {
    const Cell total = operation.total();
    if (total.nothing_right()) notes += operation.operation + ": " + nothing_right_in_words(total) + "\n";
    if (total.surplus > 0) notes += operation.operation + ": " + surplus_in_words(total, tally.max_surplus) + "\n";
    if (total.other_nearest > 0) notes += operation.operation + ": " + other_nearest_in_words(total) + "\n";
    if (total.not_asked > 0) notes += operation.operation + ": " + not_asked_in_words(total) + "\n";
  }
  return laid_out(rows) + "\n" + notes;
}

std::string one_finding(const OperationTally& tally, const OperationOutcome& shown, Speaker speaker, bool binary32,
                        const std::string& name, const Repeat& repeat) {
  const Finding& finding = *shown.counted.example;
  const Operation* operation = find_operation(tally.operation);
  const std::uint64_t cases = both(shown.counted.cases), ordinary = shown.counted.cases[0];
  std::string text = fmt::format("\n{}, {}: {}{}{}; example: {}\n", tally.operation, name_of(shown.outcome.verdict),
                                 answer_in_words(shown.outcome), counted(cases, "case"),
                                 ordinary < cases ? ", " + grouped(ordinary) + " of ordinary size" : "",
                                 place_in_words(shown.family, finding, repeat));
  if (!operation) return text;
  const auto line = [&](const std::string& key, const std::string& value) {
    text += fmt::format("  {:<9} {}\n", key, value);
  };
  const std::string families = families_in_words(shown, line_width - 12);
  if (!families.empty()) line(repeat.recorded ? "sites" : "families", families);
  line("input", one_line(operation->print(finding.question)));
  line("hex", one_line(operation->print_hexadecimal(finding.question)));
  try {
    const Examination& examined = finding.examination(*operation);
    const std::string margin = examined.margin() ? "   margin " + readable(*examined.margin()) : "";
    line("truth", one_line(readable(examined.truth())) + margin);
  } catch (const InvalidInput& refused) {
    line("truth", std::string("refused: ") + refused.what());
  }
  line(name, finding.answer.is_null() ? no_answer : one_line(readable(finding.answer)));
  line("why", wrapped(why(finding, operation, speaker, binary32), 12));
  line("repeat", repeat_command(*operation, finding.question, speaker, repeat));
  return text;
}

std::string findings(const std::vector<OperationTally>& tallies, const Declaration& declaration, Speaker speaker,
                     const std::string& name, const Repeat& repeat) {
  std::string text;
  for (const OperationTally& tally : tallies) {
    const std::vector<OperationOutcome> outcomes = outcomes_of(tally);
    for (std::size_t i = 0; i < std::min(outcomes.size(), most_outcomes); ++i)
      text += one_finding(tally, outcomes[i], speaker, declaration.binary32, name, repeat);
    if (outcomes.size() > most_outcomes)
      text += fmt::format("\n{}: {} in the file of --json\n", tally.operation,
                          counted(outcomes.size() - most_outcomes, "less frequent way"));
    for (const std::string& hint : hints(tally, declaration))
      text += "\n" + tally.operation + ": " + wrapped(hint, tally.operation.size() + 2) + "\n";
  }
  return text;
}

std::string conventions(const std::vector<OperationTally>& tallies, const std::string& name) {
  std::string text;
  for (const OperationTally& tally : tallies) {
    if (!tally.inconsistent_convention()) continue;
    const Cell sum = tally.total();
    text += fmt::format("{}: {} answers a clear touch as closed sets do in {}, as open sets do in {}\n",
                        tally.operation, name, counted(sum.touches_closed, "case"), counted(sum.touches_open, "case"));
  }
  return text.empty() ? "" : "\ninconsistent convention\n" + text;
}

}  // namespace

std::string heading(const Tally& tally) {
  const Declaration& engine = tally.declaration;
  std::string text = (tally.repeat.recorded ? "touchstone judge of " : "touchstone audit of ") + subject(engine) +
                     ", boundary " + boundary_word(engine.boundary);
  if (engine.tolerance > 0) text += fmt::format(", tolerance {}", engine.tolerance);
  if (tally.grid.size > 0) {
    text += fmt::format("; every configuration on the {0} x {0} grid, {1} of {2}", tally.grid.size,
                        tally.grid.done.size(), counted(tally.grid.shards, "shard"));
  } else {
    text += "; " + asked_in_words(tally);
  }
  if (tally.ordinary_only()) text += ", ordinary size only";
  if (!tally.undeclared.empty()) {
    constexpr std::size_t most_named = 6;
    std::string declared, undeclared;
    for (const OperationTally& operation : tally.operations)
      declared += (declared.empty() ? "" : ", ") + operation.operation;
    for (const std::string& name : tally.undeclared) undeclared += (undeclared.empty() ? "" : ", ") + name;
    if (tally.undeclared.size() > most_named) undeclared = counted(tally.undeclared.size(), "operation");
    text += "\n" + wrapped("declared: " + declared, 2) + "\n" + wrapped("not declared, so not asked: " + undeclared, 2);
  }
  return text + (tally.interrupted ? "\ninterrupted: what follows was counted until then" : "") + "\n\n";
}

std::string robust_line(const Tally& tally) {
  if (tally.robust.empty()) return "";
  const Cell sum = sum_of(tally.robust);
  std::string text = "robust, the same questions: " + counted(sum.cases(), "case") + ", " +
                     grouped(sum.count(Verdict::agree)) + " agree";
  const auto counts = sum.counts();
  for (std::size_t v = 1; v < verdict_count; ++v) {
    if (counts[v] > 0) text += ", " + grouped(counts[v]) + " " + verdict_names[v];
  }
  return text + "\n";
}

std::string text_table(const Tally& tally, Detail detail) {
  const Speaker speaker = speaker_of(tally.declaration);
  const std::string engine = speaker == Speaker::reference ? "formula" : "engine";
  std::string text = heading(tally) + counts(tally, detail) + robust_line(tally);
  if (detail == Detail::all) text += findings(tally.operations, tally.declaration, speaker, engine, tally.repeat);
  text += findings(tally.robust, {}, Speaker::robust, "robust", tally.repeat);
  return text + conventions(tally.operations, engine) + conventions(tally.robust, "robust") + "\n" +
         closing_sentence(tally);
}

}  // namespace touchstone::report
