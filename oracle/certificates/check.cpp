// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check.h"

#include <check_files.h>  // made by the build

#include <exception>
#include <map>

#include "oracle/certificates/check_reading.h"

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

void check(const json& claim) {
  expect(claim.is_object(), "claim: an object");
  for (const char* name : {"op", "input", "truth", "certificate"}) {
    expect(claim.contains(name), std::string("claim: field ") + name + " is missing");
  }
  expect(claim["op"].is_string(), "op: a string");
  const auto found = all_checks().find(claim["op"].get<std::string>());
  expect(found != all_checks().end(), "op: not an operation with certificates");
  found->second(Claim{claim["input"], claim["truth"], claim["certificate"]});
}

/// A claim is nested five deep. What is nested without end may end a program that walks it.
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

}  // namespace

std::optional<std::string> refuse(const nlohmann::json& claim) {
  try {
    check(claim);
    return std::nullopt;
  } catch (const std::exception& refusal) {
    return refusal.what();
  }
}

std::optional<std::string> refuse_text(const std::string& line) {
  if (nested_too_deep(line)) return "claim: nested at most " + std::to_string(most_nested) + " deep";
  try {
    return refuse(json::parse(line));
  } catch (const std::exception&) {
    return "not JSON";
  }
}

bool is_refused_input(const std::string& line) {
  if (nested_too_deep(line)) return false;
  const json vector = json::parse(line, nullptr, false);
  return vector.is_object() && vector.contains("refused") && !vector.contains("truth") &&
         !vector.contains("certificate");
}

}  // namespace touchstone::certify
