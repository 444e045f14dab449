// SPDX-License-Identifier: Apache-2.0
#include "program/commands/map.h"

#include <filesystem>
#include <iostream>

#include "audit/engines/notes.h"
#include "audit/parallel.h"
#include "audit/platform.h"
#include "program/commands/commands.h"
#include "program/terminal/exit_codes.h"
#include "report/pages/html.h"

namespace touchstone::program {
namespace {

constexpr std::uint32_t gap = 16, scale = 2;

/// The first map, of our reference, is only for comparison with an engine's.
bool shows_findings(const std::vector<FailureMap>& maps, bool of_engine) {
  for (std::size_t i = of_engine ? 1 : 0; i < maps.size(); ++i) {
    for (const MapClass& entry : maps[i].classes) {
      if (is_finding(entry.verdict)) return true;
    }
  }
  return false;
}

std::vector<const Operation*> all_named(const std::vector<std::string>& names) {
  std::vector<const Operation*> operations;
  for (const std::string& list : names) {
    for (const Operation* operation : operations_named(list)) operations.push_back(operation);
  }
  return operations;
}

}  // namespace

int run_map(const MapCommand& command) {
  const std::vector<const Operation*> operations = all_named(command.operations);
  const std::string directory = command.directory.empty() ? "." : command.directory;
  const int jobs = command.jobs > 0 ? command.jobs : jobs_of_machine();
  const std::filesystem::path asked = path_of(directory);
  if (asked.extension() == ".png" || asked.extension() == ".html") {
    throw UsageError("--out " + directory + ": expected a directory; the files in it are named like the operations");
  }
  std::error_code error;
  std::filesystem::create_directories(path_of(directory), error);
  if (error) throw UsageError("--out " + directory + ": cannot be made: " + error.message());
  bool found = false;
  EngineNotes notes;
  for (const Operation* operation : operations) {
    const std::unique_ptr<Engine> engine = engine_for(*operation, command.engine, command.timeout, notes);
    const bool binary32 = engine ? engine->declaration().binary32 : command.binary32;
    const std::vector<FailureMap> maps = failure_maps(*operation, jobs, binary32, engine.get());
    const std::string stem = directory + "/" + operation->name();
    try {
      write_whole_file(stem + ".png", png(side_by_side(maps, gap), scale));
      write_whole_file(stem + ".html",
                       map_page(*operation, maps, repeat_of(command.program, command.engine, command.timeout)));
    } catch (const std::runtime_error& failed) {
      throw UsageError(std::string("--out ") + failed.what());
    }
    std::cout << operation->name() << ": " << in_words(maps) << "\n  " << stem << ".png\n  " << stem << ".html\n";
    found = found || shows_findings(maps, engine != nullptr);
  }
  notes.tell(std::cerr);
  return found ? findings : nothing_found;
}

}  // namespace touchstone::program
