// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "report/maps/map_image.h"

namespace touchstone::report {

/// The contents of a report besides the tally.
struct ReportNotes {
  std::string command{};          ///< the command that was run; empty: one that gives the same tally
  const Tally* before = nullptr;  ///< an earlier audit for comparison with this one, as before and after a fix
  std::string gate{};             ///< the gate's result (audit/gate/gate.h); empty without a gate
  /// Called before each operation's page and while its map is made: its name, the number of pages written, and their
  /// total. From any thread.
  std::function<void(const std::string&, std::size_t, std::size_t)> progress{};
  /// 0: a map has at most as many squares as its operation had questions, so that the same tally gives the same bytes.
  /// Otherwise maps begin with 16 x 16 questions and are refined while fewer seconds than this have passed.
  double seconds = 0;
  std::size_t expected = 0;  ///< number of operations of a run in progress; 0: it is over
  bool pages_stand = false;  ///< `write_so_far` has written every page of this run
};

/// Writes index.html and a page for each operation of the tally into `directory`, which is created if it is missing.
/// For recorded calls all pages are without maps. Otherwise all are first written without maps, unless they exist, then
/// each again with its map, those of expensive operations and then of the worst first, and index.html at the end.
/// Every page is self-contained, and nothing is fetched: a script in the page draws and rotates figures in space, and
/// shows the squares of maps. Without scripts such figures are described, and everything else is visible. The same
/// tally gives the same bytes, whatever the jobs, except for the versions in the last line, unless seconds limit the
/// maps. With `engine` the failure maps show it, too. Throws std::runtime_error naming the file that cannot be written.
void write_report(const Tally& tally, const std::string& directory, int jobs, Engine* engine = nullptr,
                  const ReportNotes& notes = {});

/// For a run in progress: writes index.html, and the page of the most recently counted operation, without a map.
void write_so_far(const Tally& tally, const std::string& directory, const ReportNotes& notes);

using OperationMaps =
    std::vector<std::pair<std::string, std::vector<FailureMap>>>;  ///< by operation, in the tally's order
/// The worst first: by the share of wrong answers at ordinary magnitude, then at any, then by inexact numbers.
std::vector<const OperationTally*> worst_first(const Tally& tally);
std::string index_page(const Tally& tally, const OperationMaps& maps, const ReportNotes& notes = {});
std::string operation_page(const Tally& tally, std::size_t operation, const std::vector<FailureMap>& maps,
                           const ReportNotes& notes = {});
/// A page with only the maps of one operation.
std::string map_page(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat = {});

/// Throws std::runtime_error naming the file.
void write_whole_file(const std::string& file, const std::string& bytes);

}  // namespace touchstone::report
