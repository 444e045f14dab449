// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <map>

#include "audit/judged.h"
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
  for (const auto& [family, inputs] : vectors_of(operation)) {
    const auto place = std::find(families.begin(), families.end(), family);
    REQUIRE(place != families.end());
    std::size_t met = 0;
    for (std::uint64_t i = 0; i < audit::drawn_of_a_family && met < inputs.size(); ++i) {
      auto draws = audit::case_draws(operation, static_cast<std::size_t>(place - families.begin()), 1, i);
      const Question question = operation.draw(draws, static_cast<std::size_t>(place - families.begin()));
      if (catalogue::one_line(audit::with_names(operation.print(question))) == inputs[met]) ++met;
    }
    INFO(family << ": not drawn: " << (met < inputs.size() ? inputs[met] : ""));
    CHECK(met == inputs.size());
  }
}

}  // namespace touchstone::proptests::draws_tests
