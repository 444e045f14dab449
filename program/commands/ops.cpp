// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "catalogue/codec/excerpt.h"
#include "catalogue/operation/probes/listed_operations.h"
#include "catalogue/operation/probes/synonyms.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

std::string joined(const FieldNames& words) {
  std::string text;
  for (const char* word : words) text += (text.empty() ? "" : " ") + std::string(word);
  return text;
}

/// "spheres | boxes"
std::string all_fields(const Metadata& metadata) {
  std::string text = joined(metadata.fields);
  for (const auto& other : metadata.other_fields) text += " | " + joined(other);
  return text;
}

using Line = std::array<std::string, 6>;

/// Columns as wide as their content.
void print(const std::vector<Line>& lines, std::ostream& out) {
  std::array<std::size_t, 6> widths{};
  for (const Line& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  for (const Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) out << fmt::format("{:<{}}  ", line[i], widths[i]);
    out << line.back() << '\n';
  }
}

void print_table(std::ostream& out) {
  std::vector<Line> lines{{"operation", "chapter", "pages", "judged", "input", "question"}};
  for (const Operation* operation : all_operations()) {
    const Metadata& metadata = operation->metadata();
    lines.push_back({metadata.name, metadata.chapter, metadata.pages, name_of(metadata.kind), all_fields(metadata),
                     metadata.question});
  }
  print(lines, out);
}

}  // namespace

int ops_command(bool json, std::ostream& out) {
  if (json) out << listed_operations().dump(1) << '\n';
  else print_table(out);
  return nothing_found;
}

int ops_search_command(const std::vector<std::string>& words, std::ostream& out) {
  constexpr std::size_t most = 8;
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  std::vector<std::string> nearest = nearest_operations(text, most + 1);
  if (nearest.empty())
    throw UsageError("ops " + excerpt(text, most_of_a_key) + ": no operation fits; `touchstone ops` lists all");
  if (const std::string why = why_not_computed(text); !why.empty()) out << why << "; the nearest:\n";
  const bool more = nearest.size() > most;
  if (more) nearest.pop_back();
  std::size_t width = 0;
  for (const std::string& name : nearest) width = std::max(width, name.size());
  for (const std::string& name : nearest)
    out << fmt::format("{:<{}}  {}\n", name, width, find_operation(name)->metadata().question);
  if (more) out << "More fit; another word narrows them down, and `touchstone ops` lists all operations.\n";
  return nothing_found;
}

}  // namespace touchstone::program
