// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <map>

#include "audit/counting/judged.h"
#include "audit/vectors/named_files.h"
#include "audit/vectors/schemas.h"
#include "audit/vectors/vectors.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests::draws_tests {
namespace {

using catalogue::Operation;
using catalogue::Question;

/// The inputs of the vectors of each family, in their order.
std::map<std::string, std::vector<std::string>> vectors_of(const Operation& operation) {
  std::map<std::string, std::vector<std::string>> inputs;
  std::ifstream lines("vectors/" + operation.name() + ".jsonl");
  for (std::string text; std::getline(lines, text);) {
    const auto line = catalogue::Json::parse(text);
    inputs[line["family"]].push_back(catalogue::one_line(line["input"]));
  }
  inputs.erase(audit::not_finite_family);
  return inputs;
}

}  // namespace

EACH_OPERATION("draws the questions of its vectors, in their order, whatever compiler made it") {
  if (operation.metadata().is_implementation()) return;
  const auto& families = operation.families();
  std::map<std::string, std::vector<std::string>> inputs = vectors_of(operation);
  REQUIRE(!inputs.empty());
  // Two families may have one name, each of the questions of another type: the vectors of the one follow the other's.
  std::map<std::string, std::size_t> met;
  for (std::size_t family = 0; family < families.size(); ++family) {
    const std::vector<std::string>& wanted = inputs[families[family]];
    std::size_t& next = met[families[family]];
    for (std::uint64_t i = 0; i < audit::drawn_of_a_family && next < wanted.size(); ++i) {
      auto draws = audit::case_draws(operation, family, 1, i);
      const Question question = operation.draw(draws, family);
      if (catalogue::one_line(audit::with_names(operation.print(question))) == wanted[next]) ++next;
    }
  }
  for (const auto& [family, wanted] : inputs) {
    INFO(family << ": not drawn: " << (met[family] < wanted.size() ? wanted[met[family]] : ""));
    INFO("if the family was changed on purpose, write its vectors anew (./dev vectors " << operation.name() << ")");
    CHECK(met[family] == wanted.size());
  }
}

}  // namespace touchstone::proptests::draws_tests
