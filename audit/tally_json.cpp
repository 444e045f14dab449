// SPDX-License-Identifier: Apache-2.0
#include "audit/tally_json.h"

#include <charconv>

#include "audit/engines/protocol.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

Json finding_json(const Operation& operation, const Finding& finding) {
  return {{"input", operation.print(finding.question)},
          {"index", finding.index},
          {"answer", plain(finding.answer)},
          {"ulps", written(finding.judgement.ulps)},
          {"remark", finding.judgement.remark},
          {"touch", finding.judgement.touch_reading}};
}

Json cell_json(const Operation* operation, const std::string& family, const Cell& cell) {
  Json counts = Json::object(), outcomes = Json::object(), smallest = Json::object(), rules = Json::object();
  for (std::size_t v = 0; v < verdict_count; ++v) {
    counts[verdict_names[v]] = cell.counts[v];
    if (cell.smallest[v] && operation) smallest[verdict_names[v]] = finding_json(*operation, *cell.smallest[v]);
  }
  for (const auto& [outcome, n] : cell.outcomes) outcomes[outcome] = n;
  for (const auto& [rule, n] : cell.rules) rules[rule] = n;
  Json result = {{"family", family},
                 {"cases", cell.cases()},
                 {"counts", counts},
                 {"outcomes", outcomes},
                 {"touches", {{"closed", cell.touches_closed}, {"open", cell.touches_open}}},
                 {"refused", cell.refused},
                 {"rules", rules},
                 {"worst_ulps", written(cell.worst_ulps)},
                 {"smallest", smallest}};
  if (cell.surplus > 0) result["surplus"] = cell.surplus;
  if (cell.not_asked > 0) result["not_asked"] = cell.not_asked, result["given_up"] = cell.given_up;
  return result;
}

Json operations_json(const std::vector<OperationTally>& tallies) {
  Json result = Json::array();
  for (const OperationTally& tally : tallies) {
    const Operation* operation = find_operation(tally.operation);
    Json families = Json::array();
    for (const auto& [family, cell] : tally.families) families.push_back(cell_json(operation, family, cell));
    result.push_back({{"operation", tally.operation}, {"families", families}});
  }
  return result;
}

/// Longer than any text that an audit writes.
constexpr std::size_t most_of_a_text = 1000;

/// A value and where it stands in the file, so that a refusal can name it.
struct Place {
  const Json& value;
  std::string path;

  Place at(const char* name) const {
    const std::string field = member_path(path, name);
    if (!value.is_object()) throw InvalidInput(path.empty() ? "file" : path, "object");
    if (!value.contains(name)) throw InvalidInput(field, "missing");
    return {value[name], field};
  }
  template <class Visit>
  void each(const Visit& visit) const {
    if (!value.is_array()) throw InvalidInput(path, "array");
    for (std::size_t i = 0; i < value.size(); ++i) visit(Place{value[i], path + "[" + std::to_string(i) + "]"});
  }
  template <class Visit>
  void each_member(const Visit& visit) const {
    if (!value.is_object()) throw InvalidInput(path, "object");
    for (const auto& [key, part] : value.items()) visit(key, Place{part, unknown_path(path, key)});
  }
  std::string text() const {
    if (!value.is_string() || is_typed_number(value)) throw InvalidInput(path, "string");
    return excerpt(value.get_ref<const std::string&>(), most_of_a_text);
  }
  bool flag() const {
    if (!value.is_boolean()) throw InvalidInput(path, "true or false");
    return value.get<bool>();
  }
  double number() const { return read_answer_number(value, path); }
  std::uint64_t count() const {
    std::uint64_t n = 0;
    const std::string digits = is_typed_number(value) ? value.get<std::string>().substr(1) : "";
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    if (digits.empty() || error != std::errc() || stop != digits.data() + digits.size())
      throw InvalidInput(path, "count");
    return n;
  }
  std::size_t one_of(const std::vector<std::string>& words) const {
    const std::string word = text();
    std::string rule = "one of";
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (word == words[i]) return i;
      rule += (i == 0 ? " " : ", ") + words[i];
    }
    throw InvalidInput(path, rule);
  }
};

const std::vector<std::string>& verdict_words() {
  static const std::vector<std::string> words(verdict_names.begin(), verdict_names.end());
  return words;
}

Finding read_finding(const Operation& operation, Verdict verdict, const Place& place) {
  Finding finding;
  finding.question = operation.parse(place.at("input").value);
  finding.judgement.verdict = verdict;
  finding.judgement.ulps = place.at("ulps").number();
  finding.judgement.remark = place.at("remark").text();
  finding.judgement.touch_reading = static_cast<int>(place.at("touch").number());
  finding.answer = plain(place.at("answer").value);
  finding.index = place.at("index").count();
  return finding;
}

std::pair<std::string, Cell> read_cell(const Operation& operation, const Place& place) {
  Cell cell;
  place.at("counts").each_member([&](const std::string& key, const Place& n) {
    cell.counts[Place{key, n.path}.one_of(verdict_words())] = n.count();
  });
  place.at("outcomes").each_member([&](const std::string& key, const Place& n) {
    cell.outcomes[excerpt(key, most_of_a_text)] = n.count();
  });
  place.at("smallest").each_member([&](const std::string& key, const Place& finding) {
    const std::size_t v = Place{key, finding.path}.one_of(verdict_words());
    cell.smallest[v] = read_finding(operation, static_cast<Verdict>(v), finding);
  });
  cell.touches_closed = place.at("touches").at("closed").count();
  cell.touches_open = place.at("touches").at("open").count();
  if (place.value.contains("surplus")) cell.surplus = place.at("surplus").count();
  cell.refused = place.at("refused").count();
  place.at("rules").each_member(
      [&](const std::string& key, const Place& n) { cell.rules[excerpt(key, most_of_a_text)] = n.count(); });
  cell.worst_ulps = place.at("worst_ulps").number();
  if (place.value.contains("not_asked")) {
    cell.not_asked = place.at("not_asked").count();
    cell.given_up = place.at("given_up").text();
  }
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
  return declared;
}

}  // namespace

std::string tally_json(const Tally& tally) {
  const Declaration& declared = tally.declaration;
  const Json json = {{"touchstone", 1},
                     {"kind", "tally"},
                     {"engine",
                      {{"name", declared.engine},
                       {"number", declared.binary32 ? "binary32" : "binary64"},
                       {"boundary", boundary_word(declared.boundary)},
                       {"tolerance", written(declared.tolerance)}}},
                     {"seed", tally.seed},
                     {"cases", tally.cases},
                     {"grid", {{"size", tally.grid.size}, {"shards", tally.grid.shards}, {"done", tally.grid.done}}},
                     {"interrupted", tally.interrupted},
                     {"operations", operations_json(tally.operations)},
                     {"robust", operations_json(tally.robust)}};
  return one_line(json) + "\n";
}

Tally read_tally(const std::string& text) {
  const Json json = parse_line(text);
  const Place file{json, ""};
  if (file.at("touchstone").count() != 1) throw InvalidInput("touchstone", "version 1");
  if (file.at("kind").text() != "tally") throw InvalidInput("kind", "tally");
  Tally tally;
  tally.declaration = read_declaration(file.at("engine"));
  tally.seed = file.at("seed").count();
  tally.cases = file.at("cases").count();
  tally.grid.size = file.at("grid").at("size").count();
  tally.grid.shards = file.at("grid").at("shards").count();
  file.at("grid").at("done").each([&](const Place& shard) {
    const std::uint64_t index = shard.count();
    if (index < 1 || index > tally.grid.shards) throw InvalidInput(shard.path, "one of the shards, counted from 1");
    if (!tally.grid.done.empty() && index <= tally.grid.done.back()) throw InvalidInput(shard.path, "ascending");
    tally.grid.done.push_back(index);
  });
  tally.interrupted = file.at("interrupted").flag();
  tally.operations = read_operations(file.at("operations"));
  tally.robust = read_operations(file.at("robust"));
  return tally;
}

}  // namespace touchstone::audit
