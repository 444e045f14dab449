// SPDX-License-Identifier: Apache-2.0
#include "audit/counting/tally_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/counting/repeat.h"
#include "audit/engines/protocol.h"
#include "audit/place.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

/// Null if robust and oracle refuse the question.
Json truth_json(const Operation& operation, const Finding& finding) {
  try {
    return finding.examination(operation).truth();
  } catch (const InvalidInput&) {
    return nullptr;
  }
}

/// The engine whose tallies they are.
struct Whose {
  const Tally& tally;
  bool robust;
};

Json finding_json(const Operation& operation, const Finding& finding, const Whose& whose) {
  Json json = {{"input", operation.print(finding.question)},
               {"hex", operation.print_hexadecimal(finding.question)},
               {"truth", truth_json(operation, finding)},
               {"cause", cause_of(finding.judgement)},
               {"index", finding.index},
               {"answer", plain(finding.answer)},
               {"ulps", written(finding.judgement.ulps)},
               {"remark", finding.judgement.remark},
               {"touch", finding.judgement.touch_reading},
               {"range", name_of(finding.range)},
               {"features", finding.features},
               {"repeat", repeat_command(operation, finding.question, whose.tally, whose.robust)}};
  if (!finding.vector.empty()) json["vector"] = finding.vector;
  if (const auto& number = finding.judgement.number)
    json["number"] = {{"exact", written(number->exact)}, {"answered", written(number->answered)}};
  return json;
}

Json by_range_json(const ByRange& counts) {
  Json result = Json::object();
  for (std::size_t range = 0; range < range_count; ++range) result[range_names[range]] = counts[range];
  return result;
}

Json outcome_json(const Operation* operation, const JudgedOutcome& outcome, const OutcomeCount& counted,
                  const Whose& whose) {
  Json result = {{"verdict", name_of(outcome.verdict)},
                 {"truth", outcome.truth},
                 {"answer", outcome.answer},
                 {"cases", by_range_json(counted.cases)}};
  if (outcome.verdict == Verdict::rounding) result["out_of_range"] = by_range_json(counted.out_of_range);
  if (counted.example && operation) result["example"] = finding_json(*operation, *counted.example, whose);
  return result;
}

Json ordinary_json(const Cell& cell) {
  Json counts = Json::object();
  for (std::size_t v = 0; v < verdict_count; ++v)
    counts[verdict_names[v]] = cell.count(static_cast<Verdict>(v), Range::ordinary);
  return {{"cases", cell.cases(Range::ordinary)},
          {"counts", counts},
          {"cancellation", cell.cancellation()[0]},
          {"out_of_range", cell.out_of_range()[0]}};
}

Json recorded_json(const Recorded& recorded) {
  Json nearness = Json::object();
  for (std::size_t c = 0; c < nearness_classes; ++c) nearness[nearness_names[c]] = recorded.nearness[c];
  return {{"nearness", nearness},
          {"in_double", recorded.in_double},
          {"in_float", recorded.in_float},
          {"as_open_sets", recorded.as_open_sets}};
}

Recorded read_recorded(const Place& place) {
  Recorded recorded;
  for (std::size_t c = 0; c < nearness_classes; ++c)
    recorded.nearness[c] = place.at("nearness").at(nearness_names[c]).count();
  recorded.in_double = place.at("in_double").count();
  recorded.in_float = place.at("in_float").count();
  recorded.as_open_sets = place.at("as_open_sets").count();
  return recorded;
}

Json cell_json(const Operation* operation, const std::string& family, const Cell& cell, const Whose& whose) {
  Json counts = Json::object(), outcomes = Json::object(), smallest = Json::object(), rules = Json::object();
  Json entries = Json::array();
  const auto by_verdict = cell.counts();
  for (std::size_t v = 0; v < verdict_count; ++v) {
    counts[verdict_names[v]] = by_verdict[v];
    const Finding* example = cell.example(static_cast<Verdict>(v));
    if (example != nullptr && operation) smallest[verdict_names[v]] = finding_json(*operation, *example, whose);
  }
  for (const auto& [outcome, counted] : cell.outcomes)
    entries.push_back(outcome_json(operation, outcome, counted, whose));
  for (const auto& [truth, n] : cell.truths()) outcomes[truth] = n;
  for (const auto& [rule, n] : cell.rules) rules[rule] = n;
  Json result = {{"family", family},
                 {"cases", cell.cases()},
                 {"counts", counts},
                 {"cancellation", both(cell.cancellation())},
                 {"out_of_range", both(cell.out_of_range())},
                 {"ordinary", ordinary_json(cell)},
                 {"ways", entries},
                 {"outcomes", outcomes},
                 {"touches", {{"closed", cell.touches_closed}, {"open", cell.touches_open}}},
                 {"refused", cell.refused},
                 {"rules", rules},
                 {"worst_ulps", written(cell.worst_ulps)},
                 {"hash", fmt::format("{:016x}", cell.hash)},
                 {"smallest", smallest}};
  if (cell.surplus > 0) result["surplus"] = cell.surplus;
  if (cell.apart > 0) result["apart"] = cell.apart;
  if (cell.left_out > 0) result["left_out"] = cell.left_out;
  if (cell.found_on_axis > 0) result["on_axis"] = {{"found", cell.found_on_axis}, {"right_off", cell.right_off_axis}};
  if (cell.other_nearest > 0) result["other_nearest"] = cell.other_nearest;
  if (cell.other_alternative > 0) result["other_alternative"] = cell.other_alternative;
  if (cell.not_asked > 0) result["not_asked"] = cell.not_asked, result["given_up"] = cell.given_up;
  if (cell.recorded.calls() > 0) result["recorded"] = recorded_json(cell.recorded);
  return result;
}

Json operations_json(const std::vector<OperationTally>& tallies, const Whose& whose) {
  Json result = Json::array();
  for (const OperationTally& tally : tallies) {
    const Operation* operation = find_operation(tally.operation);
    Json families = Json::array();
    for (const auto& [family, cell] : tally.families) families.push_back(cell_json(operation, family, cell, whose));
    result.push_back({{"operation", tally.operation}, {"families", families}});
  }
  return result;
}

const std::vector<std::string>& verdict_words() {
  static const std::vector<std::string> words(verdict_names.begin(), verdict_names.end());
  return words;
}

const std::vector<std::string>& range_words() {
  static const std::vector<std::string> words(range_names.begin(), range_names.end());
  return words;
}

Finding read_finding(const Operation& operation, const JudgedOutcome& outcome, const Place& place) {
  Finding finding;
  finding.question = operation.parse(place.at("input").value);
  finding.judgement.verdict = outcome.verdict;
  finding.judgement.said = outcome.verdict == Verdict::invalid ? "" : outcome.answer;
  finding.judgement.ulps = place.at("ulps").number();
  finding.judgement.remark = place.at("remark").text();
  if (place.value.contains("number")) {
    const Place number = place.at("number");
    finding.judgement.number = OffNumber{number.at("exact").number(), number.at("answered").number()};
  }
  finding.judgement.touch_reading = static_cast<int>(place.at("touch").number());
  finding.answer = plain(place.at("answer").value);
  finding.index = place.at("index").count();
  if (place.value.contains("vector")) finding.vector = place.at("vector").text();
  finding.range = static_cast<Range>(place.at("range").one_of(range_words()));
  finding.features = place.at("features").count();
  static const std::vector<std::string> kinds{"cancellation", "out_of_range"};
  if (outcome.verdict == Verdict::rounding) finding.judgement.out_of_range = place.at("cause").one_of(kinds) == 1;
  return finding;
}

ByRange read_by_range(const Place& place) {
  ByRange counts{};
  for (std::size_t range = 0; range < range_count; ++range) counts[range] = place.at(range_names[range]).count();
  return counts;
}

/// Enumerators of the operation's answers ("convex/ccw"), or one of these words.
std::string outcome_text(const Operation& operation, const std::vector<std::string>& others, const Place& place) {
  const std::string text = place.text();
  if (std::find(others.begin(), others.end(), text) != others.end()) return text;
  const std::vector<std::string> words = operation.words();
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('/', from), text.size());
    if (std::find(words.begin(), words.end(), text.substr(from, to - from)) == words.end())
      throw InvalidInput(place.path, "enumerators of " + operation.name());
    from = to + 1;
  }
  return text;
}

void read_outcome(const Operation& operation, Cell& cell, const Place& place) {
  JudgedOutcome outcome;
  outcome.verdict = static_cast<Verdict>(place.at("verdict").one_of(verdict_words()));
  outcome.truth = outcome_text(operation, {"value", "refused"}, place.at("truth"));
  outcome.answer = outcome_text(operation, {"value", "true", "false", no_valid_answer, no_answer}, place.at("answer"));
  OutcomeCount counted;
  counted.cases = read_by_range(place.at("cases"));
  if (outcome.verdict == Verdict::rounding) counted.out_of_range = read_by_range(place.at("out_of_range"));
  for (std::size_t range = 0; range < range_count; ++range) {
    if (counted.out_of_range[range] > counted.cases[range])
      throw InvalidInput(place.at("out_of_range").path, "no more than cases");
  }
  if (place.value.contains("example")) counted.example = read_finding(operation, outcome, place.at("example"));
  if (!cell.outcomes.emplace(outcome, counted).second) throw InvalidInput(place.path, "duplicate outcome");
}

std::pair<std::string, Cell> read_cell(const Operation& operation, const Place& place) {
  Cell cell;
  place.at("ways").each([&](const Place& outcome) { read_outcome(operation, cell, outcome); });
  place.at("counts").each_member([&](const std::string& key, const Place& n) {
    const auto verdict = static_cast<Verdict>(Place{key, n.path}.one_of(verdict_words()));
    if (n.count() != cell.count(verdict)) throw InvalidInput(n.path, "sum of the outcomes");
  });
  cell.touches_closed = place.at("touches").at("closed").count();
  cell.touches_open = place.at("touches").at("open").count();
  if (place.value.contains("surplus")) cell.surplus = place.at("surplus").count();
  if (place.value.contains("apart")) cell.apart = place.at("apart").count();
  cell.refused = place.at("refused").count();
  place.at("rules").each_member(
      [&](const std::string& key, const Place& n) { cell.rules[excerpt(key, most_of_a_text)] = n.count(); });
  cell.worst_ulps = place.at("worst_ulps").number();
  cell.hash = place.at("hash").hexadecimal();
  if (place.value.contains("left_out")) cell.left_out = place.at("left_out").count();
  if (place.value.contains("on_axis")) {
    cell.found_on_axis = place.at("on_axis").at("found").count();
    cell.right_off_axis = place.at("on_axis").at("right_off").count();
  }
  if (place.value.contains("other_nearest")) cell.other_nearest = place.at("other_nearest").count();
  if (place.value.contains("other_alternative")) cell.other_alternative = place.at("other_alternative").count();
  if (place.value.contains("not_asked")) {
    cell.not_asked = place.at("not_asked").count();
    cell.given_up = place.at("given_up").text();
  }
  if (place.value.contains("recorded")) cell.recorded = read_recorded(place.at("recorded"));
  if (place.at("cases").count() != cell.cases()) throw InvalidInput(place.at("cases").path, "sum of the counts");
  return {place.at("family").text(), cell};
}

std::vector<OperationTally> read_operations(const Place& place) {
  std::vector<OperationTally> tallies;
  place.each([&](const Place& entry) {
    OperationTally& tally = tallies.emplace_back();
    tally.operation = entry.at("operation").text();
    const Operation* operation = find_operation(tally.operation);
    if (!operation) throw InvalidInput(entry.at("operation").path, "operation of the catalogue");
    entry.at("families").each([&](const Place& family) { tally.families.push_back(read_cell(*operation, family)); });
  });
  return tallies;
}

Declaration read_declaration(const Place& place) {
  Declaration declared;
  declared.engine = place.at("name").text();
  declared.binary32 = place.at("number").one_of({"binary64", "binary32"}) == 1;
  declared.boundary =
      static_cast<Declaration::Boundary>(place.at("boundary").one_of({"closed", "open", "unspecified"}));
  declared.tolerance = place.at("tolerance").number();
  if (place.value.contains("skew_boxes")) declared.skew_boxes = place.at("skew_boxes").flag();
  if (place.value.contains("polygons")) declared.polygons = place.at("polygons").flag();
  if (place.value.contains("pairs"))
    declared.pairs = static_cast<Declaration::Pairs>(place.at("pairs").one_of({"conservative", "exact"}));
  if (place.value.contains("alternatives")) {
    place.at("alternatives").each_member([&](const std::string& operation, const Place& answered) {
      std::set<std::size_t>& of_operation = declared.alternatives[excerpt(operation, most_of_a_text)];
      answered.each([&](const Place& which) { of_operation.insert(which.count()); });
    });
  }
  if (place.value.contains("nearest"))
    declared.nearest = static_cast<Declaration::Nearest>(place.at("nearest").one_of({"any", "named"}));
  return declared;
}

}  // namespace

std::string tally_json(const Tally& tally) {
  const Declaration& declared = tally.declaration;
  Json engine = {{"name", declared.engine},
                 {"number", declared.binary32 ? "binary32" : "binary64"},
                 {"boundary", boundary_word(declared.boundary)},
                 {"tolerance", written(declared.tolerance)}};
  if (declared.skew_boxes) engine["skew_boxes"] = true;
  if (declared.polygons) engine["polygons"] = true;
  if (declared.pairs != Declaration::Pairs::conservative) engine["pairs"] = pairs_word(declared.pairs);
  if (!declared.alternatives.empty()) engine["alternatives"] = declared.alternatives;
  if (declared.nearest != Declaration::Nearest::any) engine["nearest"] = nearest_word(declared.nearest);
  if (!tally.repeat.options.empty() || tally.repeat.program != Repeat{}.program) {
    engine["program"] = tally.repeat.program;
    engine["options"] = tally.repeat.options;
  }
  Json json = {{"touchstone", 1},
               {"kind", "tally"},
               {"version", tally.version},
               {"engine", engine},
               {"seed", tally.seed},
               {"cases", tally.cases},
               {"grid", {{"size", tally.grid.size}, {"shards", tally.grid.shards}, {"done", tally.grid.done}}},
               {"limits", {{"least", written(tally.limits.least)}, {"most", written(tally.limits.most)}}},
               {"max_surplus", written(tally.max_surplus)},
               {"interrupted", tally.interrupted},
               {"undeclared", tally.undeclared},
               {"operations", operations_json(tally.operations, {tally, false})},
               {"robust", operations_json(tally.robust, {tally, true})}};
  if (tally.by_cost) json["by_cost"] = true;
  if (!tally.logs.empty()) json["logs"] = tally.logs;
  return one_line(json) + "\n";
}

Tally read_tally(const std::string& text) {
  const Json json = parse_line(text);
  const Place file{json, ""};
  if (file.at("touchstone").count() != 1) throw InvalidInput("touchstone", "version 1");
  if (file.at("kind").text() != "tally") throw InvalidInput("kind", "tally");
  Tally tally;
  tally.version = file.at("version").text();
  tally.declaration = read_declaration(file.at("engine"));
  if (file.at("engine").value.contains("program")) {
    tally.repeat.program = file.at("engine").at("program").text();
    tally.repeat.options = file.at("engine").at("options").text();
  }
  tally.seed = file.at("seed").count();
  tally.cases = file.at("cases").count();
  if (json.contains("by_cost")) tally.by_cost = file.at("by_cost").flag();
  tally.grid.size = file.at("grid").at("size").count();
  tally.grid.shards = file.at("grid").at("shards").count();
  file.at("grid").at("done").each([&](const Place& shard) {
    const std::uint64_t index = shard.count();
    if (index < 1 || index > tally.grid.shards) throw InvalidInput(shard.path, "one of the shards, counted from 1");
    if (!tally.grid.done.empty() && index <= tally.grid.done.back()) throw InvalidInput(shard.path, "ascending");
    tally.grid.done.push_back(index);
  });
  tally.limits = {file.at("limits").at("least").number(), file.at("limits").at("most").number()};
  if (json.contains("max_surplus")) tally.max_surplus = file.at("max_surplus").number();
  tally.interrupted = file.at("interrupted").flag();
  file.at("undeclared").each([&](const Place& name) { tally.undeclared.push_back(name.text()); });
  if (json.contains("logs")) file.at("logs").each([&](const Place& log) { tally.logs.push_back(log.text()); });
  tally.repeat.recorded = !tally.logs.empty();
  tally.operations = read_operations(file.at("operations"));
  tally.robust = read_operations(file.at("robust"));
  return tally;
}

}  // namespace touchstone::audit
