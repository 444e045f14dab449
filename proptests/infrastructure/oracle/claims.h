// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/operation/probes/explained.h"
#include "proptests/catch.h"

/// The oracle's own claims as text, and programs in Python that judge them.
namespace touchstone::proptests {

/// What the oracle says of drawn questions, one JSON object each: op, input, truth, margin, certificate; some of every
/// family of every operation.
inline std::vector<nlohmann::json> drawn_claims(const char* stream, std::uint64_t each) {
  std::vector<nlohmann::json> claims;
  for (const catalogue::Operation* operation : catalogue::all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    for (std::size_t family = 0; family < operation->families().size(); ++family) {
      for (std::uint64_t i = 0; i < each; ++i) {
        catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(family, stream, i));
        const catalogue::Question question = operation->draw(draws, family);
        try {
          const auto examination = operation->examine(question);
          auto claim = catalogue::claim_of(*examination);
          if (examination->margin()) claim["margin"] = examination->margin()->get_str();
          claim["input"] = nlohmann::json::parse(operation->print_hexadecimal(question).dump());
          claims.push_back(std::move(claim));
        } catch (const InvalidInput&) {
        }
      }
    }
  }
  return claims;
}

/// Lines in a file of this process that is gone afterwards.
class LinesInFile {
 public:
  LinesInFile(const std::string& name, const std::vector<std::string>& lines)
      : path_(std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_" + name)) {
    std::ofstream out(path_);
    for (const std::string& line : lines) out << line << '\n';
  }
  ~LinesInFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  LinesInFile(const LinesInFile&) = delete;
  LinesInFile& operator=(const LinesInFile&) = delete;
  std::string path() const { return "'" + path_.string() + "'"; }

 private:
  std::filesystem::path path_;
};

/// Whether the script, run in the source folder, finds nothing; without Python it is not asked, and says so.
inline bool python_finds_nothing(const std::string& script_and_arguments) {
  if (std::system("python3 -c 'import fractions' >/dev/null 2>&1") != 0) {
    WARN("skipped: there is no python3 to run " << script_and_arguments);
    return true;
  }
  return std::system(("python3 " + script_and_arguments).c_str()) == 0;
}

}  // namespace touchstone::proptests
