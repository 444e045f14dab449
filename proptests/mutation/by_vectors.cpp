// SPDX-License-Identifier: Apache-2.0
// by_vectors FILE: the vectors of that file run on the mutants in TOUCHSTONE_MUTANTS. Exit code 1 on a false alarm,
// which is a vector that complains of the baseline.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "audit/vectors/vectors.h"
#include "proptests/mutation/surviving.h"

int main(int, char** argv) {
  std::ifstream file(argv[1]);
  const std::string folder = std::filesystem::path(argv[1]).parent_path().string();
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  touchstone::mutation::Surviving surviving(std::getenv("TOUCHSTONE_MUTANTS"));
  const bool baseline_passes = surviving.run([&] {
    if (lines.empty()) return std::string("no vectors");
    for (const std::string& line : lines) {
      const std::string complaint = touchstone::audit::robust_complaint(line, folder);
      if (!complaint.empty()) return complaint + "\n" + line;
    }
    return std::string();
  });
  return baseline_passes ? 0 : 1;
}
