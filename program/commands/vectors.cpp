// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "audit/counted.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "audit/vectors/from_logs.h"
#include "audit/vectors/manifest.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/schemas.h"
#include "catalogue/codec/expected.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path);
  if (!(file << text << std::flush)) throw UsageError(path.generic_string() + ": cannot be written: " + why_of(errno));
}

}  // namespace

int vectors_write_command(const std::string& directory, const std::string& operations, std::uint64_t seed,
                          std::ostream& out, std::ostream&) {
  const std::vector<const Operation*> chosen = operations_named(operations);
  const std::filesystem::path folder = path_of(directory);
  for (const char* part : {"meshes", "schemas"}) std::filesystem::create_directories(folder / part);
  write_text(folder / "schema.json", vector_schema().dump(1) + "\n");
  for (const NamedFile& file : named_files()) write_text(folder / file.name, file.text);
  for (const Operation* operation : chosen) {
    if (operation->metadata().is_implementation()) continue;  // it uses the vectors of the operation itself
    const Vectors vectors = vectors_of(*operation, seed);
    std::string text;
    for (const std::string& line : vectors.lines) text += line + "\n";
    const auto path = folder / (operation->name() + ".jsonl");
    write_text(path, text);
    write_text(folder / "schemas" / (operation->name() + ".json"), vector_schema(*operation).dump(1) + "\n");
    out << path.generic_string() << ": " << vectors.lines.size() << " vectors";
    if (vectors.left_out > 0) {
      out << ", " << vectors.left_out << " longer than " << operation->metadata().longest_vector
          << " characters left out";
    }
    out << '\n';
  }
  write_text(folder / manifest_name, manifest_of(directory, seed).dump(1) + "\n");
  out << (folder / "meshes").string() << ": " << named_files().size() << " meshes that vectors name\n";
  return nothing_found;
}

int vectors_from_command(const std::string& directory, const std::vector<std::string>& logs,
                         const std::string& operations, int jobs, std::ostream& out) {
  const auto hardest = hardest_of_logs(logs, operations_named(operations), jobs > 0 ? jobs : audit::jobs_of_machine());
  if (hardest.empty()) throw UsageError("the logs hold no call that is answered wrongly or is hard to answer");
  const std::filesystem::path folder = path_of(directory);
  std::filesystem::create_directories(folder / "schemas");
  write_text(folder / "schema.json", vector_schema().dump(1) + "\n");
  for (const auto& [operation, questions] : hardest) {
    std::string text;
    for (const std::string& line : vectors_of(*operation, questions)) text += line + "\n";
    const auto path = folder / (operation->name() + ".jsonl");
    const bool replaced = std::filesystem::exists(path);
    write_text(path, text);
    write_text(folder / "schemas" / (operation->name() + ".json"), vector_schema(*operation, true).dump(1) + "\n");
    out << path.generic_string() << ": " << audit::counted(questions.size(), "vector")
        << (replaced ? ", in the place of those that were there\n" : "\n");
  }
  write_text(folder / manifest_name, manifest_of(directory, 0).dump(1) + "\n");
  return nothing_found;
}

}  // namespace touchstone::program
