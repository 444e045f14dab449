// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "audit/counting/cases_of.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "report/words/ways.h"

namespace touchstone::report {

void write_whole_file(const std::string& file, const std::string& bytes) {
  std::ofstream opened(file, std::ios::binary);
  if (!opened || !opened.write(bytes.data(), static_cast<std::streamsize>(bytes.size())) || !opened.flush()) {
    throw std::runtime_error(file + ": cannot be written");
  }
}

namespace {

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(path_of(directory), error);
  if (error) throw std::runtime_error(directory + ": " + error.message());
}

/// The questions around which an engine's map may be centred: its findings, except answers that may have taken long.
std::vector<Question> found_in(const OperationTally& tally) {
  std::vector<Question> questions;
  for (const OperationOutcome& shown : outcomes_of(tally)) {
    const Verdict verdict = shown.outcome.verdict;
    if (is_finding(verdict) && verdict != Verdict::invalid) questions.push_back(shown.counted.example->question);
  }
  return questions;
}

bool is_dear(const OperationTally* tally) {
  constexpr int dear = 100;
  const Operation* operation = find_operation(tally->operation);
  return operation != nullptr && operation->metadata().cost >= dear;
}

/// The pages, as far as their maps are made.
struct Report {
  const Tally& tally;
  const std::string& directory;
  const ReportNotes& notes;
  std::vector<std::vector<FailureMap>> maps = std::vector<std::vector<FailureMap>>(tally.operations.size());

  void write_page(std::size_t operation) const {
    write_whole_file(directory + "/" + tally.operations[operation].operation + ".html",
                     operation_page(tally, operation, maps[operation], notes));
  }
  void write_index() const {
    OperationMaps named;
    for (std::size_t i = 0; i < maps.size(); ++i) named.emplace_back(tally.operations[i].operation, maps[i]);
    write_whole_file(directory + "/index.html", index_page(tally, named, notes));
  }
};

}  // namespace

void write_so_far(const Tally& tally, const std::string& directory, const ReportNotes& notes) {
  make_directory(directory);
  const Report report{tally, directory, notes};
  report.write_index();
  if (!tally.operations.empty()) report.write_page(tally.operations.size() - 1);
}

void write_report(const Tally& tally, const std::string& directory, int jobs, Engine* engine,
                  const ReportNotes& notes) {
  make_directory(directory);
  Report report{tally, directory, notes};
  report.write_index();
  if (!notes.pages_stand) in_parallel(jobs, tally.operations.size(), [&](std::size_t i) { report.write_page(i); });
  const auto started = std::chrono::steady_clock::now();
  const auto over = [&] {
    return notes.seconds > 0 &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count() >= notes.seconds;
  };
  std::vector<const OperationTally*> order = worst_first(tally);
  // A single engine is asked one question after the other, and a single operation uses all jobs.
  const bool apart = engine == nullptr && order.size() > 1;
  // The most expensive ones begin, so that no job is left with one of them at the end.
  if (apart) std::stable_partition(order.begin(), order.end(), is_dear);
  if (tally.repeat.recorded) return;  // a map would show the textbook formula, around a question that was not recorded
  constexpr int coarsest = 16;
  for (int side = coarsest; side == coarsest || (side <= MapGrid::side && !over()); side *= 2) {
    std::atomic<std::size_t> done{0};
    in_parallel(apart ? jobs : 1, order.size(), [&](std::size_t place) {
      const OperationTally& counted = *order[place];
      const auto i = static_cast<std::size_t>(&counted - tally.operations.data());
      const Operation* operation = find_operation(counted.operation);
      if (operation != nullptr) {
        MapEffort effort{side};
        if (notes.seconds == 0) effort = MapEffort::of(cases_of(*operation, tally.cases, tally.by_cost));
        effort.go_on = [&] {
          if (notes.progress) notes.progress(counted.operation, done, order.size());
          return !over();
        };
        auto maps = effort.abandoned() ? std::vector<FailureMap>()
                                       : failure_maps(*operation, apart ? 1 : jobs, tally.declaration.binary32, engine,
                                                      found_in(counted), effort);
        const bool changes = !maps.empty() || (notes.pages_stand && side == coarsest);
        if (!maps.empty()) report.maps[i] = std::move(maps);
        if (changes) report.write_page(i);
      }
      ++done;
    });
    if (notes.seconds == 0) break;
  }
  report.write_index();
}

}  // namespace touchstone::report
