// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/sarif.h"

#include <algorithm>
#include <charconv>

#include "audit/counting/repeat.h"
#include "audit/gate/shown.h"
#include "audit/version.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

std::string rule_id(const Found& found) { return found.operation + "/" + name_of(found.cause); }

Json rule_json(const Found& found) {
  const Operation* operation = find_operation(found.operation);
  Json rule = {{"id", rule_id(found)},
               {"shortDescription", {{"text", found.operation + ": " + cause_in_words(found.cause)}}}};
  if (operation) rule["fullDescription"] = {{"text", std::string(operation->metadata().question)}};
  rule["defaultConfiguration"] = {{"level", "error"}};
  return rule;
}

Json properties_json(const Tally& tally, const GateEntry& entry, const Finding* example) {
  const Found& found = entry.found;
  Json properties = {{"operation", found.operation}, {"family", found.family}, {"cause", name_of(found.cause)},
                     {"findings", found.findings},   {"cases", found.cases},   {"known", entry.known}};
  const Operation* operation = find_operation(found.operation);
  if (!example || !operation) return properties;
  properties["input"] = operation->print(example->question);
  properties["hex"] = operation->print_hexadecimal(example->question);
  properties["answer"] = plain(example->answer);
  properties["repeat"] = repeat_command(*operation, example->question, tally, false);
  return properties;
}

/// A line of source code.
struct Line {
  std::string file;
  std::uint64_t number;
};

/// The line of a call site such as "game.cpp:120"; the first of `source` if it is another text.
Line line_of(const std::string& site, const std::string& source) {
  const std::size_t colon = site.rfind(':');
  std::uint64_t number = 0;
  if (colon == std::string::npos || colon == 0) return {source, 1};
  const char* const end = site.data() + site.size();
  const auto [stop, error] = std::from_chars(site.data() + colon + 1, end, number);
  return error == std::errc() && stop == end && number > 0 ? Line{site.substr(0, colon), number} : Line{source, 1};
}

}  // namespace

std::string sarif_json(const Tally& tally, const Gate& gate, const GateResult& result, const std::string& source) {
  std::vector<std::string> ids;
  Json rules = Json::array(), results = Json::array();
  for (const GateEntry& entry : result.entries) {
    const Found& found = entry.found;
    const std::string id = rule_id(found);
    auto place = std::find(ids.begin(), ids.end(), id);
    if (place == ids.end()) {
      rules.push_back(rule_json(found));
      place = ids.insert(ids.end(), id);
    }
    const Finding* example = example_of(tally, found);
    const bool recorded = tally.repeat.recorded;
    const std::string family = found.family.empty() ? "" : (recorded ? ", " : ", family ") + found.family;
    const Line line = recorded ? line_of(found.family, source) : Line{source, 1};
    Json one = {{"ruleId", id},
                {"ruleIndex", place - ids.begin()},
                {"level", entry.fails ? "error" : "note"},
                {"message",
                 {{"text", found.operation + family + ": " + in_words(entry) +
                               (example ? "\n" + described(tally, found.operation, *example) : "")}}}};
    one["locations"] = Json::array(
        {{{"physicalLocation", {{"artifactLocation", {{"uri", line.file}}}, {"region", {{"startLine", line.number}}}}},
          {"logicalLocations", Json::array({{{"name", found.operation}, {"kind", "function"}}})}}});
    one["partialFingerprints"] = {{"operationFamilyCause/v1", id + "/" + found.family}};
    if (gate.baseline) one["baselineState"] = entry.found.findings > entry.known ? "new" : "unchanged";
    one["properties"] = properties_json(tally, entry, example);
    results.push_back(std::move(one));
  }
  const Json driver = {
      {"name", "touchstone"}, {"version", version_number}, {"semanticVersion", version_number}, {"rules", rules}};
  const Json run = {
      {"tool", {{"driver", driver}}},
      {"columnKind", "utf16CodeUnits"},
      {"results", results},
      {"properties", {{"engine", tally.declaration.engine}, {"seed", tally.seed}, {"passed", result.passed()}}}};
  const Json log = {
      {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", Json::array({run})}};
  return one_line(log) + "\n";
}

}  // namespace touchstone::audit
