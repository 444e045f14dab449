// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <set>

#include "audit/meshes/formats/mesh_file.h"
#include "geometry/invalid_input.h"
#include "proptests/catch.h"

namespace touchstone::proptests::examples_tests {
namespace {

const std::filesystem::path folder = "examples/meshes";

/// What the reader says of a file of the folder, on one line.
std::string said(const std::string& file) {
  std::string line;
  try {
    for (const std::string& part : audit::reading_of(audit::read_mesh_file((folder / file).string())))
      line += (line.empty() ? "" : "; ") + part;
    return line;
  } catch (const InvalidInput& refused) {
    const std::string what = refused.what(), in_folder = folder.string() + "/";
    return what.starts_with(in_folder) ? what.substr(in_folder.size()) : what;
  }
}

}  // namespace

TEST_CASE("examples: of each mesh file the reader says what the table says") {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path().filename().string());
  for (const char* other : {"README.md", "binary.py", "beside.bin"}) CHECK(files.erase(other) == 1);
  std::ifstream table(folder / "README.md");
  for (std::string row; std::getline(table, row);) {
    if (!row.starts_with("| [")) continue;
    const std::string file = row.substr(3, row.find(']') - 3);
    const std::size_t last = row.rfind(" | ");
    INFO(file);
    CHECK(files.erase(file) == 1);
    REQUIRE(row.ends_with(" |"));
    CHECK(said(file) == row.substr(last + 3, row.size() - last - 5));
  }
  CHECK(files.empty());
}

}  // namespace touchstone::proptests::examples_tests
