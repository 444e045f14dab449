// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check.h"

#include <exception>
#include <map>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {
namespace {

void check(const json& claim) {
  static const std::map<std::string, void (*)(const Claim&)> checks{{"explicit_line", check_explicit_line},
                                                                    {"implicit_circle", check_implicit_circle},
                                                                    {"parametric_circle", check_parametric_circle},
                                                                    {"line_point_at", check_line_point_at},
                                                                    {"point_on_segment", check_point_on_segment},
                                                                    {"line_line", check_line_line},
                                                                    {"segment_segment", check_segment_segment},
                                                                    {"ray_segment", check_ray_segment},
                                                                    {"orientation", check_orientation}};
  expect(claim.is_object(), "claim: an object");
  for (const char* name : {"op", "input", "truth", "certificate"}) {
    expect(claim.contains(name), std::string("claim: field ") + name + " is missing");
  }
  expect(claim["op"].is_string(), "op: a string");
  const auto found = checks.find(claim["op"].get<std::string>());
  expect(found != checks.end(), "op: not an operation with certificates");
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

}  // namespace touchstone::certify
