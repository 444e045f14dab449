// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "audit/counting/judged.h"
#include "audit/counting/tally_json.h"
#include "audit/engines/notes.h"
#include "audit/gate/junit.h"
#include "audit/gate/shown.h"
#include "audit/platform.h"
#include "audit/vectors/asked.h"
#include "audit/vectors/manifest.h"
#include "audit/vectors/vectors.h"
#include "catalogue/codec/excerpt.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"
#include "report/words/wording.h"

namespace touchstone::program {
namespace {

/// An engine's answers to the vectors of many files.
class EngineResult {
 public:
  EngineResult(const VectorsCheckCommand& command, Engine& engine, std::ostream& out)
      : engine_(engine), out_(out), most_shown_(command.verbose ? UINT64_MAX : usually_shown) {
    tally_.declaration = engine.declaration();
    tally_.repeat = repeat_of(command.program, command.engine, command.timeout);
  }

  void add(const std::string& file, const VectorQuestions& questions) {
    std::uint64_t found = 0;
    for (const VectorQuestions::Answered& vector : questions.ask(engine_)) {
      Cell& cell = cells_[vector.operation->name()][vector.family];
      if (!vector.reply.asked) {
        ++cell.not_asked;
        cell.given_up = vector.reply.judgement.remark;
        continue;
      }
      const Asked asked{*vector.operation, vector.question, vector.truth, vector.number, tally_.limits, vector.id};
      count(cell, asked, vector.reply.judgement, vector.reply.answer);
      if (is_finding(vector.reply.judgement.verdict) && ++found <= most_shown_) tell(file, vector);
    }
    if (found > most_shown_) out_ << file << ": " << found - most_shown_ << " more findings, which --verbose shows\n";
  }

  void not_declared(const std::string& operation) { tally_.undeclared.push_back(operation); }

  /// Prints the sum.
  const Tally& finish() {
    for (const Operation* operation : all_operations()) {
      const auto counted = cells_.find(operation->name());
      if (counted == cells_.end()) continue;
      OperationTally& all = tally_.operations.emplace_back(OperationTally{operation->name(), {}});
      for (const std::string& family : operation->families()) {
        const auto cell = counted->second.find(family);
        if (cell == counted->second.end()) continue;
        all.families.emplace_back(family, std::move(cell->second));
        counted->second.erase(cell);
      }
      for (auto& [family, cell] : counted->second) all.families.emplace_back(family, std::move(cell));
    }
    const Cell sum = sum_of(tally_.operations);
    std::string causes;
    for (std::size_t v = 1; v < verdict_count; ++v) {
      const std::uint64_t cases = sum.count(static_cast<Verdict>(v));
      if (cases > 0) causes += (causes.empty() ? "; " : ", ") + std::to_string(cases) + " " + verdict_names[v];
    }
    for (const OperationTally& operation : tally_.operations) {
      const Cell total = operation.total();
      if (operation.inconsistent_convention())
        out_ << operation.operation << ": inconsistent convention: a clear touch is answered as closed sets do in "
             << counted(total.touches_closed, "vector") << ", as open sets do in " << total.touches_open << '\n';
      if (operation.too_much_surplus(tally_.max_surplus))
        out_ << operation.operation << ": " << surplus_in_words(total, tally_.max_surplus) << '\n';
    }
    out_ << tally_.declaration.engine << ": " << sum.cases() << " vectors asked, " << sum.findings() << " findings"
         << causes << '\n';
    if (sum.not_asked > 0) out_ << sum.not_asked << " vectors not asked: the engine was " << sum.given_up << '\n';
    return tally_;
  }

 private:
  /// Prints the details of a finding as in an audit's files, below file, line and verdict.
  void tell(const std::string& file, const VectorQuestions::Answered& vector) {
    Finding finding;
    finding.question = vector.question, finding.vector = vector.id;
    finding.judgement = vector.reply.judgement, finding.answer = vector.reply.answer;
    std::string lines = described(tally_, vector.operation->name(), finding);
    for (std::size_t at = 0; at + 1 < lines.size() && at != std::string::npos; at = lines.find('\n', at + 1))
      lines.insert(at == 0 ? 0 : at + 1, "  ");
    out_ << file << ": line " << vector.number << ": " << name_of(vector.reply.judgement.verdict) << '\n' << lines;
  }

  static constexpr std::uint64_t usually_shown = 10;
  Engine& engine_;
  std::ostream& out_;
  std::uint64_t most_shown_;
  Tally tally_;
  std::map<std::string, std::map<std::string, Cell>> cells_;  ///< by operation and family
};

/// The requested files of vectors, sorted by name.
std::vector<std::string> files_of(const VectorsCheckCommand& command) {
  const std::string& directory = command.directory;
  if (!std::filesystem::is_directory(path_of(directory)))
    throw UsageError(directory + ": expected a directory of vectors");
  const bool all = command.operations == "all";
  const std::vector<const Operation*> operations = operations_named(command.operations);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path_of(directory))) {
    const auto named = [&](const Operation* operation) { return entry.path().stem() == operation->name(); };
    const bool chosen = all || std::any_of(operations.begin(), operations.end(), named);
    if (entry.path().extension() == ".jsonl" && chosen) files.push_back(entry.path().generic_string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw UsageError(directory + ": expected at least one file .jsonl");
  return files;
}

}  // namespace

int vectors_check_command(const VectorsCheckCommand& command, std::ostream& out, std::ostream& err) {
  const std::string& directory = command.directory;
  const std::vector<std::string> files = files_of(command);
  require_writable("--json", command.json_file);
  require_writable("--junit", command.junit_file);
  std::ostream& readable = is_standard_output(command.json_file) ? err : out;
  EngineNotes notes;
  const std::unique_ptr<Engine> engine =
      command.engine.empty() ? nullptr : pipe_engine(command.engine, command.timeout, nullptr, &notes);
  std::optional<EngineResult> result;
  if (engine) result.emplace(command, *engine, readable);
  std::uint64_t checked = 0, refused = 0;
  const std::vector<std::string> differences =
      command.operations == "all" ? manifest_complaints(directory) : std::vector<std::string>();
  for (const std::string& complaint : differences)
    err << "touchstone: " << excerpt((path_of(directory) / path_of(complaint)).generic_string(), 1000) << '\n';
  for (const std::string& file : files) {
    // A file of an operation that the engine does not have is skipped.
    const Operation* const operation = find_operation(path_of(file).stem().string());
    if (engine && operation != nullptr && !engine->supports(operation->name())) {
      result->not_declared(operation->name());
      continue;
    }
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
  bool found = false;
  if (result) {
    const Tally& tally = result->finish();
    found = tally.has_findings();
    write_file("--json", command.json_file, tally_json(tally));
    write_file("--junit", command.junit_file, junit_xml(tally, held_against(tally, {})));
  }
  readable << checked << " vectors, " << refused << " refused\n";
  return refused > 0 || !differences.empty() || found ? findings : nothing_found;
}

}  // namespace touchstone::program
