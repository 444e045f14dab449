// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"
#include "proptests/property.h"

namespace touchstone::proptests::simplest_truth_tests {
namespace {

const char* const script = "proptests/infrastructure/oracle/simplest_truth.py ";

/// One {"name", "words"} a line; a method answers the question of another operation.
std::vector<std::string> listed_operations() {
  std::vector<std::string> lines;
  for (const catalogue::Operation* operation : catalogue::all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    lines.push_back(nlohmann::json{{"name", operation->name()}, {"words", operation->words()}}.dump());
  }
  return lines;
}

/// Not of the long lists: the second truth takes time that grows fast with their length. Meshes are no such lists.
bool is_short(const nlohmann::json& input) {
  if (!input.is_structured()) return true;
  if (input.is_array() && input.size() > 16) return false;
  for (const auto& [key, part] : input.items())
    if (key != "vertices" && key != "faces" && !is_short(part)) return false;
  return true;
}

}  // namespace

TEST_CASE("truth: answers and margins are those of a slower and shorter program in fractions") {
  std::vector<std::string> lines;
  for (const nlohmann::json& claim : drawn_claims("simplest truth", static_cast<std::uint64_t>(scaled(12))))
    if (is_short(claim.at("input"))) lines.push_back(claim.dump());
  REQUIRE(lines.size() > 2000);
  const LinesInFile claims("truths.jsonl", lines), operations("operations.jsonl", listed_operations());
  CHECK(python_finds_nothing(script + claims.path() + " " + operations.path()));
}

TEST_CASE("truth: an operation without a second truth, and a word that was never compared, are noticed") {
  const LinesInFile no_claims("no_claims.jsonl", {});
  for (const char* operation : {R"({"name":"unheard_of","words":[]})", R"({"name":"orientation","words":["left"]})"}) {
    const LinesInFile operations("operations.jsonl", {operation});
    CHECK(!python_finds_nothing(script + no_claims.path() + " " + operations.path()));
  }
  const LinesInFile excused("operations.jsonl", {R"({"name":"parametric_circle","words":[]})"});
  CHECK(python_finds_nothing(script + no_claims.path() + " " + excused.path()));
}

}  // namespace touchstone::proptests::simplest_truth_tests
