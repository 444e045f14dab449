// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "catalogue/codec/json.h"
#include "simulate/gas/gas.h"

namespace touchstone::simulate::gas {

/// Cubes on a lattice, each moved by a random whole shift, with random whole velocities.
struct GasScene {
  std::string title, about;
  Whole side = 1, room = 0, until = 0;
  bool planar = false;                  ///< one layer, which nothing leaves
  Whole speed = 0;                      ///< no component of a velocity is greater
  std::uint32_t steps_per_second = 60;  ///< of engines beside it (referee.h)
  std::vector<Cube> cubes;
};

/// Whether the scene has a field `gas`: then it is one of these, and none of simulate/world/scene.h.
bool is_gas(const catalogue::Json& json);
/// Strict as read_scene is. docs/simulate.md describes the fields.
GasScene read_gas(const catalogue::Json& json);

/// Runs forwards and backwards, and prints what was kept. Whether all of it was.
bool run_gas(const GasScene& scene, std::ostream& out);

}  // namespace touchstone::simulate::gas
