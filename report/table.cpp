// SPDX-License-Identifier: Apache-2.0
#include "report/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/engines/protocol.h"
#include "report/wording.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t columns = verdict_count + 1;
constexpr std::size_t line_width = 120;

struct Row {
  std::string name;
  std::array<std::string, columns> cells;
};

Row row_of(const std::string& name, const Cell& cell) {
  Row row{name, {}};
  const auto counts = cell.counts();
  row.cells[0] = grouped(cell.cases());
  for (std::size_t v = 0; v < verdict_count; ++v) row.cells[v + 1] = counts[v] == 0 ? "-" : grouped(counts[v]);
  return row;
}

Row header_row() {
  Row row{"operation, family", {}};
  row.cells[0] = "cases";
  for (std::size_t v = 0; v < verdict_count; ++v) row.cells[v + 1] = verdict_names[v];
  return row;
}

/// Right-aligned columns as narrow as their content; a name too long for what they leave of the line stands alone on
/// its own.
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
    text += "\n";
  }
  return text;
}

std::string heading(const Tally& tally) {
  const Declaration& declared = tally.declaration;
  std::string text = "touchstone audit of " + subject(declared) + ", boundary " + boundary_word(declared.boundary);
  if (declared.tolerance > 0) text += fmt::format(", tolerance {}", declared.tolerance);
  if (tally.grid.size > 0) {
    text += fmt::format("; every configuration on the {0} x {0} grid, {1} of {2}", tally.grid.size,
                        tally.grid.done.size(), counted(tally.grid.shards, "shard"));
  } else {
    text += "; " + counted(tally.cases, "case") + " per operation, seed " + std::to_string(tally.seed);
  }
  return text + (tally.interrupted ? "\ninterrupted: what follows was counted until then" : "") + "\n\n";
}

std::string counts(const Tally& tally) {
  std::vector<Row> rows{header_row()};
  for (const OperationTally& operation : tally.operations) {
    rows.push_back({});
    const Cell total = operation.total();
    rows.push_back(row_of(operation.operation, total));
    if (total.count(Verdict::unsupported) == total.cases()) continue;  // the engine does not know it
    for (const auto& [family, cell] : operation.families) rows.push_back(row_of("  " + family, cell));
  }
  rows.push_back({});
  rows.push_back(row_of("all", sum_of(tally.operations)));
  const Cell sum = sum_of(tally.operations);
  std::string rules;
  for (const auto& [rule, n] : sum.rules) rules += (rules.empty() ? " (" : ", ") + rule + ": " + grouped(n);
  if (!rules.empty()) rules += ")";
  std::string notes =
      sum.refused == 0 ? "" : "drawn but outside the contract, so no cases: " + grouped(sum.refused) + rules + "\n";
  for (const OperationTally& operation : tally.operations) {
    const Cell total = operation.total();
    if (total.surplus > 0)
      notes += operation.operation + ": " + counted(total.surplus, "element") + " listed beyond the truth\n";
    if (total.not_asked > 0) notes += operation.operation + ": " + not_asked_in_words(total) + "\n";
  }
  return laid_out(rows) + "\n" + notes;
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

/// Prose broken between words so that it fits beside a key of `indent` columns.
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

std::string one_finding(const OperationTally& tally, Verdict verdict, const Smallest& smallest, Speaker speaker,
                        bool binary32, const std::string& name) {
  const Finding& finding = *smallest.finding;
  const Operation* operation = find_operation(tally.operation);
  std::string text =
      fmt::format("\n{}, {}: {}, the smallest in family {} (case {})\n", tally.operation, name_of(verdict),
                  counted(tally.total().count(verdict), "case"), smallest.family, finding.index);
  if (!operation) return text;
  const auto line = [&](const std::string& key, const std::string& value) {
    text += fmt::format("  {:<9} {}\n", key, value);
  };
  line("input", one_line(operation->print(finding.question)));
  line("hex", one_line(operation->print_hexadecimal(finding.question)));
  try {
    const auto examination = operation->examine(finding.question);
    const std::string margin = examination->margin() ? "   margin " + readable(*examination->margin()) : "";
    line("truth", one_line(readable(examination->truth())) + margin);
  } catch (const InvalidInput& refused) {
    line("truth", std::string("refused: ") + refused.what());
  }
  line(name, finding.answer.is_null() ? "no answer" : one_line(readable(finding.answer)));
  line("why", wrapped(why(finding, operation, speaker, binary32), 12));
  line("repeat", repeat_command(*operation, finding.question, speaker));
  return text;
}

std::string findings(const std::vector<OperationTally>& tallies, Speaker speaker, bool binary32,
                     const std::string& name) {
  std::string text;
  for (const OperationTally& tally : tallies) {
    for (std::size_t v = 1; v < verdict_count; ++v) {
      const auto verdict = static_cast<Verdict>(v);
      const Smallest smallest = smallest_of(tally, verdict);
      if (smallest.finding && verdict != Verdict::unsupported)
        text += one_finding(tally, verdict, smallest, speaker, binary32, name);
    }
  }
  return text;
}

std::string conventions(const std::vector<OperationTally>& tallies, const std::string& name) {
  std::string text;
  for (const OperationTally& tally : tallies) {
    if (!tally.inconsistent_convention()) continue;
    const Cell sum = tally.total();
    text += fmt::format("{}: {} answers a touch as closed sets do in {}, as open sets do in {}\n", tally.operation,
                        name, counted(sum.touches_closed, "case"), counted(sum.touches_open, "case"));
  }
  return text.empty() ? "" : "\ninconsistent convention\n" + text;
}

}  // namespace

std::string text_table(const Tally& tally) {
  const std::string engine = speaker_of(tally.declaration) == Speaker::reference ? "reference" : "engine";
  return heading(tally) + counts(tally) + robust_line(tally) +
         findings(tally.operations, speaker_of(tally.declaration), tally.declaration.binary32, engine) +
         findings(tally.robust, Speaker::robust, false, "robust") + conventions(tally.operations, engine) +
         conventions(tally.robust, "robust") + "\n" + closing_sentence(tally);
}

}  // namespace touchstone::audit
