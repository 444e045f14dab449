// SPDX-License-Identifier: Apache-2.0
// Vectors, asked of mutants: by_vectors FILE, the mutants being those in TOUCHSTONE_MUTANTS. Exit code 1 if a vector
// complains while no mutant is on.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "audit/vectors/vectors.h"
#include "proptests/selftests/alive.h"

int main(int, char** argv) {
  std::ifstream file(argv[1]);
  const std::string folder = std::filesystem::path(argv[1]).parent_path().string();
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  touchstone::selftests::Alive alive(std::getenv("TOUCHSTONE_MUTANTS"));
  const bool silent = alive.ask([&] {
    if (lines.empty()) return std::string("no vectors");
    for (const std::string& line : lines) {
      const std::string complaint = touchstone::audit::robust_complaint(line, folder);
      if (!complaint.empty()) return complaint + "\n" + line;
    }
    return std::string();
  });
  return silent ? 0 : 1;
}
