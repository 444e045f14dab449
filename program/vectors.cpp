// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "audit/vectors/manifest.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/schemas.h"
#include "catalogue/codec/excerpt.h"
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
  const std::filesystem::path folder = directory;
  for (const char* part : {"meshes", "schemas"}) std::filesystem::create_directories(folder / part);
  write_text(folder / "schema.json", vector_schema().dump(1) + "\n");
  for (const NamedFile& file : named_files()) write_text(folder / file.name, file.text);
  for (const Operation* operation : chosen) {
    if (operation->card().is_method()) continue;  // the vectors of the operation itself serve
    const Vectors vectors = vectors_of(*operation, seed);
    std::string text;
    for (const std::string& line : vectors.lines) text += line + "\n";
    const auto path = folder / (operation->name() + ".jsonl");
    write_text(path, text);
    write_text(folder / "schemas" / (operation->name() + ".json"), vector_schema(*operation).dump(1) + "\n");
    out << path.string() << ": " << vectors.lines.size() << " vectors";
    if (vectors.left_out > 0) {
      out << ", " << vectors.left_out << " longer than " << operation->card().longest_vector << " characters left out";
    }
    out << '\n';
  }
  write_text(folder / manifest_name, manifest_of(directory, seed).dump(1) + "\n");
  out << (folder / "meshes").string() << ": " << named_files().size() << " meshes that vectors name\n";
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
  const std::vector<std::string> differences = manifest_complaints(directory);
  for (const std::string& complaint : differences)
    err << "touchstone: " << excerpt((std::filesystem::path(directory) / complaint).string(), 1000) << '\n';
  for (const std::string& file : files) {
    std::set<std::string> ids;
    checked += each_line(file, [&](std::uint64_t number, const std::string& text) {
      std::string complaint = vector_complaint(text, directory);
      if (complaint.empty() && !ids.insert(Json::parse(text)["id"].get<std::string>()).second)
        complaint = "id: no other line's";
      if (complaint.empty()) return;
      ++refused;
      err << place(file, number) << complaint << '\n';
    });
  }
  out << checked << " vectors, " << refused << " refused\n";
  return refused > 0 || !differences.empty() ? findings : nothing_found;
}

}  // namespace touchstone::audit
