// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "report/maps/map_image.h"

namespace touchstone::report {

/// What a report contains in addition to the tally.
struct ReportNotes {
  std::string command{};          ///< the line that was called; empty: one that gives the same tally
  const Tally* before = nullptr;  ///< an earlier audit to be compared with this one, as before and after a fix
  std::string gate{};             ///< what the gate says (audit/gate/gate.h); empty where none decides
  /// Called before each operation's page and while its map is made: its name, how many pages are written, and how many
  /// there will be. From any thread.
  std::function<void(const std::string&, std::size_t, std::size_t)> progress{};
  /// 0: a map has no more squares than its operation was asked questions, so that the same tally gives the
  /// same bytes. Else they begin with 16 x 16 questions and are made finer while fewer seconds than this have passed.
  double seconds = 0;
  std::size_t expected = 0;  ///< operations of a run that goes on; 0: it is over
  bool pages_stand = false;  ///< `write_so_far` has written every page of this run
};

/// Writes index.html and a page for each operation of the tally into `directory`, which is made if it is not there:
/// of recorded calls without maps; else first all without maps, unless these stand, then each again with its map,
/// those of dear operations and then of the worst first, and index.html at the end.
/// Every page stands alone, nothing fetched: figures in space are drawn and rotated, and maps walked over, by a script
/// in the page. Without scripts such figures are described, and all else is visible. The same tally gives the same
/// bytes, whatever the jobs, but for the versions in the last line, unless seconds limit the maps. With `engine` the
/// failure maps show it too. Throws std::runtime_error naming the file that cannot be written.
void write_report(const Tally& tally, const std::string& directory, int jobs, Engine* engine = nullptr,
                  const ReportNotes& notes = {});

/// Of a run that goes on: writes index.html, and the page of the operation that was counted last, without a map.
void write_so_far(const Tally& tally, const std::string& directory, const ReportNotes& notes);

using OperationMaps =
    std::vector<std::pair<std::string, std::vector<FailureMap>>>;  ///< by operation, in the tally's order
/// The worst first: by the share that is wrong at ordinary size, then at any, then by inexact numbers.
std::vector<const OperationTally*> worst_first(const Tally& tally);
std::string index_page(const Tally& tally, const OperationMaps& maps, const ReportNotes& notes = {});
std::string operation_page(const Tally& tally, std::size_t operation, const std::vector<FailureMap>& maps,
                           const ReportNotes& notes = {});
/// A page with the maps of one operation alone.
std::string map_page(const Operation& operation, const std::vector<FailureMap>& maps, const Repeat& repeat = {});

/// Throws std::runtime_error naming the file.
void write_whole_file(const std::string& file, const std::string& bytes);

}  // namespace touchstone::report
