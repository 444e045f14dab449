// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/invalid_input.h"
#include "proptests/catch.h"
#include "simulate/scene_reading.h"

/// Scenes for tests, in few words.
namespace touchstone::proptests {

inline simulate::Scene scene_from(const std::string& text) { return simulate::read_scene(catalogue::parse_line(text)); }

/// {"touchstone_scene":1, advance, then what is given}.
inline std::string scene_text(const std::string& advance, const std::string& rest) {
  return "{\"touchstone_scene\":1,\"advance\":{" + advance + "}," + rest + "}";
}

/// A particle's place and velocity.
inline std::string particle(const std::string& position, const std::string& velocity) {
  return "{\"shape\":{\"particle\":{}},\"position\":" + position + ",\"velocity\":" + velocity + "}";
}
inline std::string sphere(double radius, const std::string& position, const std::string& velocity) {
  return "{\"shape\":{\"sphere\":{\"radius\":" + catalogue::decimal(radius) + "}},\"position\":" + position +
         ",\"velocity\":" + velocity + "}";
}

inline const std::string floor_of_scene = R"("walls":[{"name":"floor","normal":[0,2,0],"offset":0}])";

inline std::vector<double> numbers_of(const simulate::State<double>& state) {
  std::vector<double> numbers;
  for (const auto& [p, v] : state) numbers.insert(numbers.end(), {p.x, p.y, p.z, v.x, v.y, v.z});
  return numbers;
}

}  // namespace touchstone::proptests
