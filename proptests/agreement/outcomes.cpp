// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>

#include "audit/counting/tally.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"
#include "proptests/property.h"

namespace touchstone::proptests::outcomes_tests {
namespace {

using robust::Stage;

/// Of a family; fewer where a question is dear or very dear, and no more where they have had that many numbers.
constexpr std::uint64_t drawn = 1500, drawn_dear = 500, drawn_very_dear = 150, very_dear = 200, most_numbers = 30'000;
/// The formula in double is judged on so many questions of a family.
constexpr std::uint64_t judged = 500, judged_dear = 100;

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

/// The stages of the answer or, where robust tells the stage of the decision alone, of the decision.
const catalogue::StageFunctions& reported_stages(const catalogue::RowFunctions& row) {
  return row.stages.decided_by != nullptr ? row.stages : row.decision_stages;
}

const char* name_of(Stage stage) {
  return std::array{"filter", "enclosed", "lattice", "exact"}[static_cast<std::size_t>(stage)];
}

/// "polygon[3]: simple: its edge must not meet edge 5" -> "polygon: simple: its edge must not meet edge"
std::string rule_of(const std::string& refusal) {
  static const std::regex indices(R"(\[[0-9]+\])"), named(R"((edge|vertex|->|, and) [0-9]+)");
  return std::regex_replace(std::regex_replace(refusal, indices, ""), named, "$1");
}

struct Reached {
  std::set<std::string> outcomes, refused;
  std::set<Stage> stages;
  std::set<std::string> wrong;  ///< the causes of the wrong answers of the formula in double

  std::size_t size() const { return outcomes.size() + refused.size() + stages.size() + wrong.size(); }
  /// A line of the ledger.
  std::string line(const std::string& family) const {
    catalogue::Json line = {{"family", family}};
    if (!outcomes.empty()) line["outcomes"] = outcomes;
    for (const Stage stage : stages) line["stages"].push_back(name_of(stage));
    if (!refused.empty()) line["refused"] = refused;
    if (!wrong.empty()) line["wrong"] = wrong;
    return line.dump();
  }
};

/// `kept`: the family's line of the ledger. With fewer cases than usual no more are drawn once all of it is reached.
Reached reached_by(const Operation& operation, std::size_t family, const std::string& kept) {
  const bool till_reached = scaled(100) < 100;
  Reached reached;
  const auto decided_by = reported_stages(operation.row()).decided_by;
  const bool cheap = operation.metadata().cost == 1;
  const bool is_very_dear = operation.metadata().cost >= static_cast<int>(very_dear);
  const std::uint64_t cases = cheap          ? drawn
                              : is_very_dear ? drawn_very_dear
                                             : drawn_dear,
                      judge = cheap ? judged : judged_dear;
  std::uint64_t numbers = 0;
  std::size_t found = 0;
  for (std::uint64_t i = 0; i < cases && numbers < most_numbers; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, operation.families()[family].c_str(), i));
    const catalogue::Question question = operation.draw(draws, family);
    numbers += question.numbers.size();
    try {
      const auto examination = operation.examine(question);
      reached.outcomes.insert(examination->outcome());
      if (i < judge && catalogue::is_finding(examination->judge_reference().verdict))
        reached.wrong.insert(audit::cause_of(examination->judge_reference()));
      if (decided_by != nullptr) reached.stages.insert(decided_by(question, 0));
    } catch (const InvalidInput& refused) {
      reached.refused.insert(rule_of(refused.what()));
    }
    if (!till_reached || reached.size() == found) continue;
    found = reached.size();
    if (reached.line(operation.families()[family]) == kept) break;
  }
  return reached;
}

/// Whether a hard case is called after something that breaks formulas in double; not of those moved by an ulp (+ulp).
bool is_named_after_a_hazard(const std::string& family) {
  static const std::regex hazard(
      "(^|[^+]*_)(ulps?|overflow\\w*|underflow\\w*|subnormal|range|cancel\\w*|nearly|near|hair|rounded|huge|tiny|lost|"
      "binade|least)(_[^+]*|$)");
  return std::regex_match(family, hazard);
}

/// Why the formula in double is never wrong on such a family, from proptests/agreement/never_wrong.jsonl; empty where
/// no line names it. A family "*" stands for all of the operation.
std::string why_never_wrong(const Operation& operation, const std::string& family) {
  std::ifstream lines("proptests/agreement/never_wrong.jsonl");
  for (std::string line; std::getline(lines, line);) {
    const catalogue::Json reason = catalogue::Json::parse(line);
    if (reason["op"] == operation.name() && (reason["family"] == family || reason["family"] == "*"))
      return reason["why"].get<std::string>();
  }
  return "";
}

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool is_hard_case(const Operation& operation, const std::string& family) {
  const auto& hard_cases = operation.row().hard_cases;
  return std::any_of(hard_cases.begin(), hard_cases.end(), [&](const auto& hard) { return hard.name == family; });
}

}  // namespace

EACH_OPERATION("every outcome and stage is reached, and every family asks what it is meant to ask") {
  if (operation.metadata().is_implementation()) return;  // families and oracle are those of the operation
  const std::set<std::string> possible = possible_outcomes(operation);
  std::set<std::string> missing = possible, missing_stages;
  for (const auto& one : reported_stages(operation.row()).each) missing_stages.insert(name_of(one.stage));
  // What the families reached when somebody last looked: a change of a family that loses an outcome, a stage or a
  // refusal shows here. Written anew, to be looked at, with TOUCHSTONE_WRITE_GOLDEN=1.
  const std::string file = "proptests/agreement/reached/" + operation.name() + ".jsonl";
  const std::vector<std::string> kept = lines_of(file);
  std::vector<std::string> ledger;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    const std::string& name = operation.families()[family];
    INFO(name);
    const Reached reached = reached_by(operation, family, family < kept.size() ? kept[family] : "");
    for (const std::string& outcome : reached.outcomes) {
      for (const std::string& word : split(outcome)) {
        CHECK(possible.count(word) == 1);
        missing.erase(word);
      }
    }
    for (const Stage stage : reached.stages) missing_stages.erase(name_of(stage));
    for (const std::string& rule : reached.refused) CHECK(rule.find("finite number") == std::string::npos);
    // A family without a valid question is one that breaks a rule of its shape on purpose: always the same one.
    if (reached.outcomes.empty()) {
      std::set<std::string> rules;
      for (const std::string& refusal : reached.refused) rules.insert(refusal.substr(refusal.find(": ") + 2));
      CHECK(rules.size() == 1);
      CHECK(is_hard_case(operation, name));
    }
    if (is_named_after_a_hazard(name) && !reached.outcomes.empty()) {
      const std::string reasons = "proptests/agreement/never_wrong.jsonl";
      INFO((reached.wrong.empty() ? "the formula in double is never wrong here: draw numbers that round, or explain in "
                                  : "the formula in double is wrong here: delete the line of ")
           << reasons);
      CHECK(reached.wrong.empty() == !why_never_wrong(operation, name).empty());
    }
    ledger.push_back(reached.line(name));
  }
  INFO("no family reaches: " << Catch::Detail::stringify(missing) << Catch::Detail::stringify(missing_stages));
  CHECK(missing.empty());
  CHECK(missing_stages.empty());
  INFO(file << ", which TOUCHSTONE_WRITE_GOLDEN=1 writes anew");
  if (std::getenv("TOUCHSTONE_WRITE_GOLDEN") != nullptr) {
    std::ofstream written(file);
    for (const std::string& line : ledger) written << line << '\n';
  }
  const std::vector<std::string> now = lines_of(file);
  REQUIRE(now.size() == ledger.size());
  for (std::size_t family = 0; family < ledger.size(); ++family) CHECK(now[family] == ledger[family]);
}

}  // namespace touchstone::proptests::outcomes_tests
