// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_boxes.h"

namespace touchstone::certify {
namespace {

std::vector<Rational> corner(const json& value, const std::string& what) {
  expect(value.is_array() && (value.size() == 2 || value.size() == 3), what + ": a list of two or three");
  std::vector<Rational> coordinates;
  for (const json& coordinate : value)
    coordinates.push_back(number(coordinate, what + "[" + std::to_string(coordinates.size()) + "]"));
  return coordinates;
}

}  // namespace

Box box(const json& value, const std::string& what) {
  only(value, what, {"min", "max"});
  const Box result{corner(value["min"], what + ".min"), corner(value["max"], what + ".max")};
  expect(result.max.size() == result.axes(), what + ".max: as many coordinates as min");
  for (std::size_t k = 0; k < result.axes(); ++k)
    expect(result.min[k] <= result.max[k], what + ".max[" + std::to_string(k) + "]: min <= max");
  return result;
}

}  // namespace touchstone::certify
