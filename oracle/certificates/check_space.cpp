// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

void array_of_three(const json& value, const std::string& what) {
  expect(value.is_array() && value.size() == 3, what + ": a list of three");
}

}  // namespace

Triple point_in_space(const json& value, const std::string& what) {
  array_of_three(value, what);
  return {number(value[0], what + "[0]"), number(value[1], what + "[1]"), number(value[2], what + "[2]")};
}

Plane plane(const json& value, const std::string& what) {
  only(value, what, {"normal", "offset"});
  const Plane result{point_in_space(value["normal"], what + ".normal"), number(value["offset"], what + ".offset")};
  expect(!(result.normal == Triple{0, 0, 0}), what + ".normal: nonzero normal");
  return result;
}

std::vector<Triple> polygon_in_space(const json& value, const std::string& what) {
  expect(value.is_array() && value.size() >= 3, what + ": at least 3 vertices");
  std::vector<Triple> vertices;
  for (const json& vertex : value)
    vertices.push_back(point_in_space(vertex, what + "[" + std::to_string(vertices.size()) + "]"));
  return vertices;
}

Triple exact_triple(const json& value, const std::string& what) {
  array_of_three(value, what);
  return {exact_value(value[0], what + "[0]"), exact_value(value[1], what + "[1]"),
          exact_value(value[2], what + "[2]")};
}

Triple triple(const Claim& claim, const char* name) {
  return exact_triple(claim.certificate[name], std::string("certificate.") + name);
}

}  // namespace touchstone::certify
