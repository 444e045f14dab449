// SPDX-License-Identifier: Apache-2.0
#include "proptests/golden.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "proptests/catch.h"

namespace touchstone::proptests {

void check_golden(const std::string& file, const std::string& text) {
  const std::string path = "proptests/infrastructure/" + file;
  if (std::getenv("TOUCHSTONE_WRITE_GOLDEN") != nullptr) std::ofstream(path) << text;
  std::ifstream golden(path);
  std::istringstream found(text);
  for (std::size_t number = 1; golden || found; ++number) {
    std::string expected, line;
    std::getline(golden, expected), std::getline(found, line);
    if (line == expected && !golden == !found) continue;
    FAIL_CHECK(path << ":" << number << ":\nexpected " << expected << "\nfound    " << line);
    return;
  }
  SUCCEED(path);
}

}  // namespace touchstone::proptests
