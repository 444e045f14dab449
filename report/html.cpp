// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "report/ways.h"

namespace touchstone::report {

void write_whole_file(const std::string& file, const std::string& bytes) {
  std::ofstream opened(file, std::ios::binary);
  if (!opened || !opened.write(bytes.data(), static_cast<std::streamsize>(bytes.size())) || !opened.flush()) {
    throw std::runtime_error(file + ": cannot be written");
  }
}

namespace {

/// Around which an engine's map may be centred: what was found of it, but for answers that may have taken long.
std::vector<Question> found_in(const OperationTally& tally) {
  std::vector<Question> questions;
  for (const WayOfOperation& shown : ways_of(tally)) {
    const Verdict verdict = shown.way.verdict;
    if (is_finding(verdict) && verdict != Verdict::invalid) questions.push_back(shown.counted.example->question);
  }
  return questions;
}

}  // namespace

void write_report(const Tally& tally, const std::string& directory, int jobs, Engine* engine,
                  const ReportNotes& notes) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::runtime_error(directory + ": " + error.message());
  OperationMaps maps;
  for (std::size_t i = 0; i < tally.operations.size(); ++i) {
    const std::string& name = tally.operations[i].operation;
    if (notes.progress) notes.progress(name, i, tally.operations.size());
    const Operation* operation = find_operation(name);
    std::vector<FailureMap> shown;
    if (operation)
      shown = failure_maps(*operation, jobs, tally.declaration.binary32, engine, found_in(tally.operations[i]));
    write_whole_file(directory + "/" + name + ".html", operation_page(tally, i, shown, notes));
    if (operation) maps.emplace_back(name, std::move(shown));
  }
  write_whole_file(directory + "/index.html", index_page(tally, maps, notes));
}

}  // namespace touchstone::report
