// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "proptests/oracle/claims.h"

namespace touchstone::proptests {

TEST_CASE("truth: answers and margins are those of a slower and shorter program in fractions") {
  std::vector<std::string> lines;
  for (const nlohmann::json& claim : drawn_claims("simplest truth", 30)) lines.push_back(claim.dump());
  REQUIRE(lines.size() > 2000);
  const LinesInFile claims("truths.jsonl", lines);
  CHECK(python_finds_nothing("proptests/oracle/simplest_truth.py " + claims.path()));
}

}  // namespace touchstone::proptests
