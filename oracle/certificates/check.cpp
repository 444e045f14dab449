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
  try {
    return refuse(json::parse(line));
  } catch (const std::exception&) {
    return "not JSON";
  }
}

bool is_refused_input(const std::string& line) {
  const json vector = json::parse(line, nullptr, false);
  return vector.is_object() && vector.contains("refused") && !vector.contains("truth") &&
         !vector.contains("certificate");
}

}  // namespace touchstone::certify
