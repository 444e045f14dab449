// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "audit/vectors/named_files.h"
#include "program/commands.h"
#include "program/program.h"

namespace touchstone::audit {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text << std::flush)) throw UsageError(path.string() + ": a file that can be written");
}

}  // namespace

int vectors_write_command(const std::string& directory, const std::string& operations, std::uint64_t seed,
                          std::ostream& out, std::ostream&) {
  const std::vector<const Operation*> chosen = operations_named(operations);
  std::filesystem::create_directories(std::filesystem::path(directory) / "meshes");
  write_text(std::filesystem::path(directory) / "schema.json", vector_schema().dump(1) + "\n");
  for (const NamedFile& file : named_files()) write_text(std::filesystem::path(directory) / file.name, file.text);
  for (const Operation* operation : chosen) {
    if (operation->card().is_method()) continue;  // the vectors of the operation itself serve
    const Vectors vectors = vectors_of(*operation, seed);
    std::string text;
    for (const std::string& line : vectors.lines) text += line + "\n";
    const auto path = std::filesystem::path(directory) / (operation->name() + ".jsonl");
    write_text(path, text);
    out << path.string() << ": " << vectors.lines.size() << " vectors";
    if (vectors.left_out > 0) {
      out << ", " << vectors.left_out << " longer than " << operation->card().longest_vector << " characters left out";
    }
    out << '\n';
  }
  out << (std::filesystem::path(directory) / "meshes").string() << ": " << named_files().size()
      << " meshes that vectors name\n";
  return nothing_found;
}

int vectors_check_command(const std::string& directory, std::ostream& out, std::ostream& err) {
  if (!std::filesystem::is_directory(directory)) throw UsageError(directory + ": a directory of vectors");
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw UsageError(directory + ": at least one file .jsonl");
  std::uint64_t checked = 0, refused = 0;
  for (const std::string& file : files) {
    checked += each_line(file, [&](std::uint64_t number, const std::string& text) {
      const std::string complaint = vector_complaint(text, directory);
      if (complaint.empty()) return;
      ++refused;
      err << place(file, number) << complaint << '\n';
    });
  }
  out << checked << " vectors, " << refused << " refused\n";
  return refused > 0 ? findings : nothing_found;
}

}  // namespace touchstone::audit
