// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "catalogue/codec/json.h"
#include "simulate/gas/gas.h"

namespace touchstone::simulate::gas {

/// Cubes on a lattice, each shifted by a random integer vector, with random integer velocities.
struct GasScene {
  std::string title, about;
  Int64 side = 1, room = 0, until = 0;
  bool planar = false;                  ///< one layer, which no cube leaves
  Int64 speed = 0;                      ///< the limit of each velocity component
  std::uint32_t steps_per_second = 60;  ///< for engines compared with it (referee.h)
  std::vector<Cube> cubes;
};

/// True if the scene has a field `gas`: then it is one of these, not one of simulate/world/scene.h.
bool is_gas(const catalogue::Json& json);
/// Strict like read_scene. docs/simulate.md describes the fields.
GasScene read_gas(const catalogue::Json& json);

/// Runs forwards and backwards, and prints the conserved quantities. Returns whether all were conserved.
bool run_gas(const GasScene& scene, std::ostream& out);

}  // namespace touchstone::simulate::gas
