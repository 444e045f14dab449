// SPDX-License-Identifier: Apache-2.0
#include "report/screen/recorded.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "audit/counted.h"

namespace touchstone::report {
namespace {

constexpr std::size_t numbers_of_row = nearness_classes + 3;
struct RecordedRow {
  std::string name;
  std::array<std::string, numbers_of_row> cells;
};

RecordedRow recorded_row(const std::string& name, const Recorded& recorded) {
  RecordedRow row{name, {}};
  for (std::size_t c = 0; c < nearness_classes; ++c)
    row.cells[c] = recorded.nearness[c] == 0 ? "." : grouped(recorded.nearness[c]);
  row.cells[nearness_classes] = grouped(recorded.in_double);
  row.cells[nearness_classes + 1] = grouped(recorded.in_float);
  row.cells[nearness_classes + 2] = grouped(recorded.as_open_sets);
  return row;
}

}  // namespace

std::string recorded_table(const Tally& tally) {
  std::vector<RecordedRow> rows{
      {"operation, call site",
       {"tie", "<1", "<10", "<100", "<1e4", "<1e6", "<1e9", "more", "double", "float", "open"}}};
  for (const OperationTally& operation : tally.operations) {
    const Recorded all = operation.total().recorded;
    if (all.calls() == 0) continue;
    rows.push_back(recorded_row(operation.operation, all));
    if (operation.families.size() < 2) continue;
    for (const auto& [site, cell] : operation.families) rows.push_back(recorded_row("  " + site, cell.recorded));
  }
  if (rows.size() == 1) return "";
  std::size_t name_width = 0;
  std::array<std::size_t, numbers_of_row> widths{};
  for (const RecordedRow& row : rows) {
    name_width = std::max(name_width, row.name.size());
    for (std::size_t c = 0; c < numbers_of_row; ++c) widths[c] = std::max(widths[c], row.cells[c].size() + 2);
  }
  std::string text =
      "\nThe columns up to \"more\" say how far the textbook formula was from another course, in units of its own\n"
      "rounding. The last three count the calls that the formula gets wrong in double and in float, and those that\n"
      "open sets answer otherwise than closed ones.\n";
  for (const RecordedRow& row : rows) {
    text += fmt::format("{:<{}}", row.name, name_width);
    for (std::size_t c = 0; c < numbers_of_row; ++c) text += fmt::format("{:>{}}", row.cells[c], widths[c]);
    text += "\n";
  }
  return text;
}

}  // namespace touchstone::report
