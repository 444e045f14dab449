// SPDX-License-Identifier: Apache-2.0
#include "program/map.h"

#include <filesystem>
#include <iostream>

#include "audit/parallel.h"
#include "program/commands.h"
#include "program/program.h"
#include "report/html.h"

namespace touchstone::audit {
namespace {

constexpr std::uint32_t gap = 16, scale = 2;

bool shows_findings(const std::vector<FailureMap>& maps) {
  for (const FailureMap& map : maps) {
    for (const MapClass& entry : map.classes) {
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

int run_map(const std::vector<std::string>& names, const std::string& out_directory, bool binary32, int jobs) {
  const std::vector<const Operation*> operations = all_named(names);
  const std::string directory = out_directory.empty() ? "." : out_directory;
  const std::filesystem::path asked(directory);
  if (asked.extension() == ".png" || asked.extension() == ".html") {
    throw UsageError("--out " + directory + ": a directory; the files in it are named like the operations");
  }
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw UsageError("--out " + directory + ": a directory that can be written");
  bool found = false;
  for (const Operation* operation : operations) {
    const std::vector<FailureMap> maps = failure_maps(*operation, jobs > 0 ? jobs : jobs_of_machine(), binary32);
    const std::string stem = directory + "/" + operation->name();
    try {
      write_whole_file(stem + ".png", png(side_by_side(maps, gap), scale));
      write_whole_file(stem + ".html", map_page(*operation, maps));
    } catch (const std::runtime_error& failed) {
      throw UsageError(std::string("--out ") + failed.what());
    }
    std::cout << operation->name() << ": " << in_words(maps) << "\n  " << stem << ".png\n  " << stem << ".html\n";
    found = found || shows_findings(maps);
  }
  return found ? findings : nothing_found;
}

}  // namespace touchstone::audit
