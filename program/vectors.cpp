// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/vectors.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "audit/engines/notes.h"
#include "audit/vectors/asked.h"
#include "audit/vectors/manifest.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/schemas.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"
#include "program/commands.h"
#include "program/program.h"
#include "report/wording.h"

namespace touchstone::program {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path);
  if (!(file << text << std::flush)) throw UsageError(path.string() + ": cannot be written: " + why_of(errno));
}

/// What an engine answered to the vectors of many files.
class EngineResult {
 public:
  EngineResult(Engine& engine, std::ostream& out) : engine_(engine), out_(out) {}

  void add(const std::string& file, const VectorQuestions& questions) {
    std::uint64_t found = 0;
    for (const VectorQuestions::Answered& vector : questions.ask(engine_)) {
      if (!vector.asked) {
        ++not_asked_;
        given_up_ = vector.judgement.remark;
        continue;
      }
      const Verdict verdict = vector.judgement.verdict;
      ++counts_[static_cast<std::size_t>(verdict)];
      if (!is_finding(verdict) || ++found > most_told) continue;
      out_ << file << ": line " << vector.number << ": " << name_of(verdict) << ": expected "
           << excerpt(one_line(vector.truth), most_of_an_answer) << ", got "
           << (vector.answer.is_null() ? "no answer" : excerpt(one_line(readable(vector.answer)), most_of_an_answer));
      if (!vector.judgement.remark.empty()) out_ << " (" << vector.judgement.remark << ")";
      out_ << '\n';
    }
    if (found > most_told) out_ << file << ": " << found - most_told << " more findings\n";
  }

  /// Tells the sum. Whether there was a finding.
  bool finish() {
    std::uint64_t asked = 0, findings = 0;
    std::string causes;
    for (std::size_t v = 0; v < verdict_count; ++v) {
      asked += counts_[v];
      if (v > 0 && counts_[v] > 0)
        causes += (causes.empty() ? "; " : ", ") + std::to_string(counts_[v]) + " " + verdict_names[v];
      if (is_finding(static_cast<Verdict>(v))) findings += counts_[v];
    }
    out_ << engine_.declaration().engine << ": " << asked << " vectors asked, " << findings << " findings" << causes
         << '\n';
    if (not_asked_ > 0) out_ << not_asked_ << " vectors not asked: the engine was " << given_up_ << '\n';
    return findings > 0 || not_asked_ > 0;
  }

 private:
  static constexpr std::uint64_t most_told = 10;
  static constexpr std::size_t most_of_an_answer = 200;
  Engine& engine_;
  std::ostream& out_;
  std::array<std::uint64_t, verdict_count> counts_{};
  std::uint64_t not_asked_ = 0;
  std::string given_up_;
};

}  // namespace

int vectors_write_command(const std::string& directory, const std::string& operations, std::uint64_t seed,
                          std::ostream& out, std::ostream&) {
  const std::vector<const Operation*> chosen = operations_named(operations);
  const std::filesystem::path folder = directory;
  for (const char* part : {"meshes", "schemas"}) std::filesystem::create_directories(folder / part);
  write_text(folder / "schema.json", vector_schema().dump(1) + "\n");
  for (const NamedFile& file : named_files()) write_text(folder / file.name, file.text);
  for (const Operation* operation : chosen) {
    if (operation->card().is_implementation()) continue;  // the vectors of the operation itself serve
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

int vectors_check_command(const VectorsCheckCommand& command, std::ostream& out, std::ostream& err) {
  const std::string& directory = command.directory;
  if (!std::filesystem::is_directory(directory)) throw UsageError(directory + ": expected a directory of vectors");
  const bool all = command.operations == "all";
  const std::vector<const Operation*> operations = operations_named(command.operations);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const auto named = [&](const Operation* operation) { return entry.path().stem() == operation->name(); };
    const bool chosen = all || std::any_of(operations.begin(), operations.end(), named);
    if (entry.path().extension() == ".jsonl" && chosen) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw UsageError(directory + ": expected at least one file .jsonl");
  EngineNotes notes;
  const std::unique_ptr<Engine> engine =
      command.engine.empty() ? nullptr : pipe_engine(command.engine, command.timeout, nullptr, &notes);
  std::optional<EngineResult> result;
  if (engine) result.emplace(*engine, out);
  std::uint64_t checked = 0, refused = 0;
  const std::vector<std::string> differences = all ? manifest_complaints(directory) : std::vector<std::string>();
  for (const std::string& complaint : differences)
    err << "touchstone: " << excerpt((std::filesystem::path(directory) / complaint).string(), 1000) << '\n';
  for (const std::string& file : files) {
    // A file of an operation that the engine does not have is none of its business.
    const Operation* const operation = find_operation(std::filesystem::path(file).stem().string());
    if (engine && operation != nullptr && !engine->supports(operation->name())) continue;
    std::optional<VectorQuestions> questions;
    if (engine) questions.emplace(*engine, directory);
    std::set<std::string> ids;
    checked += each_line(file, [&](std::uint64_t number, const std::string& text) {
      if (questions) questions->add(number, text);
      std::string complaint = vector_complaint(text, directory);
      if (complaint.empty() && !ids.insert(Json::parse(text)["id"].get<std::string>()).second)
        complaint = "id: no other line's";
      if (complaint.empty()) return;
      ++refused;
      err << place(file, number) << complaint << '\n';
    });
    if (questions) result->add(file, *questions);
  }
  notes.tell(err);
  const bool found = result && result->finish();
  out << checked << " vectors, " << refused << " refused\n";
  return refused > 0 || !differences.empty() || found ? findings : nothing_found;
}

}  // namespace touchstone::program
