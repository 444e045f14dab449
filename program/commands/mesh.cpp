// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "audit/meshes/in_words.h"
#include "audit/meshes/repair.h"
#include "audit/platform.h"
#include "catalogue/codec/excerpt.h"
#include "geometry/invalid_input.h"
#include "program/commands/commands.h"
#include "program/terminal/names.h"
#include "program/terminal/progress.h"
#include "report/pages/mesh_page.h"

namespace touchstone::program {
namespace {

void require_other_file(const std::string& option, const std::string& written, const std::string& read) {
  std::error_code unknown;
  if (written == read || std::filesystem::equivalent(path_of(written), path_of(read), unknown))
    throw UsageError(option + ": " + written + ": is the mesh that is read");
}

/// The result for one file.
struct Row {
  MeshFile file;
  std::optional<Diagnosis> diagnosis;  ///< nullopt if the file cannot be read
};

void print_words(const Row& row, std::ostream& out) {
  const std::vector<std::string> lines = description_of(row.file, *row.diagnosis);
  for (const std::string& line : lines) out << (&line == &lines[0] ? "" : "  ") << line << '\n';
  out << verdict_of(*row.diagnosis) << '\n';
  for (const FoundDefect& found : row.diagnosis->found) {
    out << "- " << found.what << '\n';
    if (!found.where.empty()) out << "  " << found.where << '\n';
    out << "  to mend: " << found.mend << '\n';
  }
}

void print_repair(const MeshCommand& command, const MeshFile& file, const Repaired& repair, std::ostream& out) {
  const std::vector<std::string>& changes = repair.changes;
  if (command.repair.empty()) {
    if (changes.empty()) return;
    out << "--repair OUT would do this:\n";
  } else {
    out << command.repair << ": written, " << (changes.empty() ? "with no change\n" : "with these changes:\n");
  }
  for (const std::string& change : changes) out << "- " << change << '\n';
  if (const std::string lost = not_kept(file); !lost.empty() && !command.repair.empty())
    out << "Not kept: " << lost << '\n';
  out << "After that: " << defects_in_short(repair.left) << '\n';
}

/// Columns as narrow as possible, with numbers right-aligned.
void print_table(const std::vector<Row>& rows, std::ostream& out) {
  using Cells = std::array<std::string, 6>;
  std::vector<Cells> cells{Cells{"file", "vertices", "faces", "parts", "solid", "the worst"}};
  for (const Row& row : rows) {
    if (!row.diagnosis) {
      cells.push_back({row.file.name, "", "", "", "", "cannot be read"});
      continue;
    }
    const Diagnosis& found = *row.diagnosis;
    cells.push_back({row.file.name, std::to_string(found.vertices), std::to_string(found.faces),
                     std::to_string(found.components), found.solid() ? "yes" : "no",
                     found.solid() ? "" : found.found[0].what});
  }
  std::array<std::size_t, 6> width{};
  for (const auto& row : cells)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  for (const auto& row : cells) {
    std::string line = fmt::format("{:{}}  {:>{}}  {:>{}}  {:>{}}  {:{}}  {}", row[0], width[0], row[1], width[1],
                                   row[2], width[2], row[3], width[3], row[4], width[4], row[5]);
    out << line.erase(line.find_last_not_of(' ') + 1) << '\n';
  }
}

/// The result is diagnosed as it reads back: STL has only triangles, with separate vertices.
void write_repaired(const std::string& name, Repaired& repair, const TellStep& tell) {
  const std::string text = text_of_mesh(repair.mesh, name);
  write_file("--repair", name, text);
  if (repair.mesh.faces.empty()) return;
  const MeshFile again = parse_mesh_file(name, text);
  if (again.vertices != repair.mesh.vertices || again.faces != repair.mesh.faces)
    repair.left = diagnosed(again, {}, tell);
}

Json json_of(const Row& row, const MeshCommand& command, const std::optional<Repaired>& repair) {
  Json json = json_of(row.file, *row.diagnosis);
  if (!repair) return json;
  json["repair"] = {{"changes", repair->changes}, {"left", json_of(repair->mesh, repair->left)}};
  if (!command.repair.empty()) json["repair"]["file"] = command.repair;
  return json;
}

void require_usage(const MeshCommand& command) {
  for (const auto& [option, written] : {std::pair{"--repair", &command.repair}, std::pair{"--page", &command.page}}) {
    if (written->empty()) continue;
    if (command.files.size() > 1) throw UsageError(std::string(option) + ": expected one mesh, got several files");
    require_other_file(option, *written, command.files[0]);
  }
  if (!command.repair.empty()) text_of_mesh({}, command.repair);  // refuses an unknown ending
  if (!command.repair.empty() && command.repair == command.page)
    throw UsageError("--page: " + command.page + ": is the file of --repair");
}

}  // namespace

int mesh_command(const MeshCommand& command, std::ostream& out, std::ostream& err) {
  require_usage(command);
  const Preparation& how = command.preparation;
  Progress progress(err, is_terminal(Stream::error), {}, 0);
  const bool alone = command.files.size() == 1;
  std::ostream& words = is_standard_output(command.page) ? err : out;
  std::vector<Row> rows;
  bool refused = false, found_any = false;
  for (const std::string& name : command.files) {
    const TellStep tell = [&](const std::string& step) { progress.tell(name + ": " + step); };
    Row& row = rows.emplace_back();
    row.file.name = excerpt(name, 200);
    std::optional<Repaired> repair;
    try {
      tell("reading");
      row.file = read_mesh_file(name);
      row.diagnosis = diagnosed(row.file, how, tell);
      if (!command.repair.empty() || (alone && !row.diagnosis->solid()))
        repair = repaired(row.file, how, *row.diagnosis, tell);
    } catch (const InvalidInput& wrong) {
      err << "touchstone: " << excerpt(wrong.what(), 2000) << '\n';
      refused = true;
      continue;
    }
    if (!command.repair.empty()) write_repaired(command.repair, *repair, tell);
    if (!command.page.empty()) write_file("--page", command.page, report::mesh_page(row.file, *row.diagnosis));
    progress.end();
    found_any = found_any || !(command.repair.empty() ? *row.diagnosis : repair->left).solid();
    if (command.json) {
      words << one_line(json_of(row, command, repair)) << '\n';
    } else if (alone) {
      print_words(row, words);
      if (repair) print_repair(command, row.file, *repair, words);
    }
    MeshFile named;  // the data for the table
    named.name = row.file.name;
    row.file = std::move(named);
  }
  if (!command.json && !alone) print_table(rows, out);
  return refused ? bad_usage : found_any ? findings : nothing_found;
}

}  // namespace touchstone::program
