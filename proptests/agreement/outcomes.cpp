// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests {
namespace {

/// Of a family; a third of it where a question is dear, and no more where they have had that many numbers.
constexpr std::uint64_t drawn = 1500, drawn_dear = 500, most_numbers = 30'000;

/// The words of an outcome: "convex/ccw" has two.
std::vector<std::string> split(const std::string& outcome) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= outcome.size();) {
    const std::size_t end = std::min(outcome.find('/', at), outcome.size());
    words.push_back(outcome.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::set<std::string> possible_outcomes(const Operation& operation) {
  const std::vector<std::string> words = operation.words();
  return words.empty() ? std::set<std::string>{"value"} : std::set<std::string>(words.begin(), words.end());
}

struct Reached {
  std::map<std::string, std::uint64_t> outcomes;
  std::set<std::string> refusals;
};

Reached reached_by(const Operation& operation, std::size_t family) {
  Reached reached;
  const std::uint64_t cases = operation.card().price == audit::Price::thin ? drawn : drawn_dear;
  std::uint64_t numbers = 0;
  for (std::uint64_t i = 0; i < cases && numbers < most_numbers; ++i) {
    Choices choices = Choices::seeded(audit::seed_of(1, operation.families()[family].c_str(), i));
    const audit::Question question = operation.draw(choices, family);
    numbers += question.numbers.size();
    try {
      ++reached.outcomes[operation.examine(question)->outcome()];
    } catch (const InvalidInput& refused) {
      reached.refusals.insert(refused.what());
    }
  }
  return reached;
}

/// "polygon[3]: simple: its edge must not meet edge 5" -> "simple: its edge must not meet edge"
std::string rule_of(const std::string& refusal) {
  std::string rule = refusal.substr(refusal.find(": ") + 2);
  while (!rule.empty() && (std::isdigit(static_cast<unsigned char>(rule.back())) != 0 || rule.back() == ' '))
    rule.pop_back();
  return rule;
}

bool is_hard_case(const Operation& operation, const std::string& family) {
  const auto& names = operation.families();
  return std::find(names.begin(), names.end(), family + "+ulp") != names.end();
}

}  // namespace

EACH_OPERATION("every outcome is reached, and every family asks what it is meant to ask") {
  if (operation.card().is_method()) return;  // families and oracle are those of the operation
  std::set<std::string> missing = possible_outcomes(operation);
  const std::set<std::string> possible = missing;
  audit::Json ledger = audit::Json::object();
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    const std::string& name = operation.families()[family];
    INFO(name);
    ledger[name] = audit::Json::array();
    const Reached reached = reached_by(operation, family);
    for (const auto& [outcome, count] : reached.outcomes) {
      for (const std::string& word : split(outcome)) {
        CHECK(possible.count(word) == 1);
        missing.erase(word);
      }
      ledger[name].push_back(outcome);
    }
    for (const std::string& refusal : reached.refusals) CHECK(refusal.find("finite number") == std::string::npos);
    // A family without a valid question is one that breaks a rule of its shape on purpose: always the same one.
    if (reached.outcomes.empty()) {
      std::set<std::string> rules;
      for (const std::string& refusal : reached.refusals) rules.insert(rule_of(refusal));
      CHECK(rules.size() == 1);
      CHECK(is_hard_case(operation, name));
    }
  }
  INFO("outcomes that no family reaches: " << Catch::Detail::stringify(missing));
  CHECK(missing.empty());
  // What the families reached when somebody last looked: a change of a family that loses an outcome shows here. Written
  // anew, to be looked at, with TOUCHSTONE_WRITE_REACHED=1.
  const std::string file = "proptests/agreement/reached/" + operation.name() + ".json";
  if (std::getenv("TOUCHSTONE_WRITE_REACHED") != nullptr) std::ofstream(file) << ledger.dump(1) << '\n';
  std::ifstream kept(file);
  INFO(file);
  REQUIRE(kept.good());
  CHECK(audit::Json::parse(kept) == ledger);
}

}  // namespace touchstone::proptests
