// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check.h"

#include <check_files.h>  // made by the build

#include <exception>
#include <set>
#include <vector>

#include "oracle/certificates/check_reading.h"
#include "oracle/certificates/named_file.h"

namespace touchstone::certify {
namespace {

const Checks& all_checks() {
  static const Checks all = [] {
    Checks merged;
    for (Checks (*of_a_file)() : checks_of_all_files) merged.merge(of_a_file());
    return merged;
  }();
  return all;
}

void expect_fields(const json& claim, std::initializer_list<const char*> names) {
  expect(claim.is_object(), "claim: an object");
  for (const char* name : names) {
    expect(claim.contains(name), std::string("claim: field ") + name + " is missing");
  }
}

Check check_of(const json& claim) {
  expect(claim["op"].is_string(), "op: a string");
  const auto found = all_checks().find(claim["op"].get<std::string>());
  expect(found != all_checks().end(), "op: not an operation with certificates");
  return found->second;
}

bool refuses_input(const json& line) {
  return line.is_object() && line.contains("refused") && !line.contains("truth") && !line.contains("certificate");
}

/// Every check reads the input first, in the order in which the contract names its rules: so it complains about the
/// first rule that is broken.
void check_refused(const json& line) {
  expect_fields(line, {"op", "input"});
  const json &refused = line["refused"], nothing;
  only(refused, "refused", {"field", "rule"});
  expect(refused["field"].is_string() && refused["rule"].is_string(), "refused: field and rule are strings");
  const std::string field = refused["field"].get<std::string>();
  const Check check = check_of(line);
  std::string broken;
  try {
    check(Claim{line["input"], nothing, nothing});
  } catch (const Refusal& refusal) {
    broken = refusal.what();
  }
  const bool of_input = line["input"].is_object() && line["input"].contains(field.substr(0, field.find_first_of(".[")));
  expect(of_input && broken == field + ": " + refused["rule"].get<std::string>(),
         "refused: this is not the first rule that the input breaks");
}

void check(const json& claim) {
  if (refuses_input(claim)) return check_refused(claim);
  expect_fields(claim, {"op", "input", "truth", "certificate"});
  const bool both = claim.contains("refused") && claim["refused"].is_object();
  expect(!both, "claim: a truth or refused, not both");
  check_of(claim)(Claim{claim["input"], claim["truth"], claim["certificate"]});
}

/// A claim is nested five deep. Unlimited nesting could crash a recursive traversal.
constexpr int most_nested = 64;

bool nested_too_deep(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') ++i;
    else if (c == '"') in_string = !in_string;
    else if (!in_string && (c == '[' || c == '{') && ++depth > most_nested) return true;
    else if (!in_string && (c == ']' || c == '}')) --depth;
  }
  return false;
}

/// A text must have one meaning: text that parsers read differently - a duplicate key, a byte order mark, a zero byte -
/// is not JSON. nullopt if it is not.
std::optional<json> parsed(const std::string& text) {
  if (text.starts_with("\xef\xbb\xbf") || text.find('\0') != std::string::npos) return std::nullopt;
  std::vector<std::set<std::string>> keys;
  bool twice = false;
  json value = json::parse(
      text,
      [&](int, json::parse_event_t event, json& key) {
        if (event == json::parse_event_t::object_start) keys.emplace_back();
        if (event == json::parse_event_t::object_end) keys.pop_back();
        if (event == json::parse_event_t::key) twice = !keys.back().insert(key.get<std::string>()).second || twice;
        return true;
      },
      false);
  return twice || value.is_discarded() ? std::nullopt : std::optional<json>(std::move(value));
}

/// Inserts the contents of files where the input names them.
void read_named_files(json& claim, const std::string& folder) {
  if (!claim.is_object() || !claim.contains("input") || !claim["input"].is_object()) return;
  for (const auto& [field, value] : claim["input"].items()) {
    if (!value.is_string()) continue;
    const std::string name = value.get<std::string>();
    const auto text = text_of_named_file(folder, field, name);
    if (!text) continue;
    auto held = nested_too_deep(*text) ? std::nullopt : parsed(*text);
    expect(held.has_value(), field + ": " + name + ": JSON, nested at most " + std::to_string(most_nested) + " deep");
    value = std::move(*held);
  }
}

}  // namespace

std::optional<std::string> refuse(const nlohmann::json& claim) {
  try {
    check(claim);
    return std::nullopt;
  } catch (const std::exception& refusal) {
    return refusal.what();
  }
}

std::optional<std::string> refuse_text(const std::string& line, const std::string& folder) {
  if (nested_too_deep(line)) return "claim: nested at most " + std::to_string(most_nested) + " deep";
  auto claim = parsed(line);
  if (!claim) return "not JSON";
  try {
    read_named_files(*claim, folder);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return refuse(*claim);
}

bool is_refused_input(const std::string& line) {
  if (nested_too_deep(line)) return false;
  const auto claim = parsed(line);
  return claim && refuses_input(*claim);
}

}  // namespace touchstone::certify
