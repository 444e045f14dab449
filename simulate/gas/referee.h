// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulate/engine_run.h"
#include "simulate/gas/gas_scene.h"

/// An exact gas as referee of an engine: the first hit that the engine answers otherwise.
namespace touchstone::simulate::gas {

/// The gas as a scene for engines: a metre is the side of a cube, and the greatest speed of the gas is 1 m/s; no
/// gravity, no loss, option 2. A planar gas lies in z = 0. What is whole in the gas is exact in float as long as the
/// side and the speed are powers of 2 and coordinates have no more than 24 bits.
Scene scene_of(const GasScene& gas);

/// What a gas does up to a time, cube by cube.
class Record {
 public:
  /// Throws GasError, also where a group of cubes made the unit of length smaller: velocities are no longer whole then.
  Record(const GasScene& gas, Whole until);

  struct Turn {
    std::size_t hit;                  ///< its place in `hits`
    std::array<Whole, 3> velocity{};  ///< afterwards
  };
  const std::vector<Hit>& hits() const { return hits_; }
  /// The velocities of a cube, one after another, from the start.
  const std::vector<Turn>& turns(std::size_t cube) const { return turns_[cube]; }

 private:
  std::vector<Hit> hits_;
  std::vector<std::vector<Turn>> turns_;
};

/// Where an engine parts from the gas.
struct WrongHit {
  std::size_t hit;                 ///< its place among the hits of the gas
  std::size_t cube;                ///< that gave it away
  std::uint64_t step;              ///< in which it did
  std::array<double, 3> velocity;  ///< that it then had, in units of the gas
  bool missed;  ///< it flew on as before the hit; else its velocity is one that the gas does not have
};

struct Verdict {
  std::string engine, ended;  ///< why it made no more steps; empty if it went on to the end
  bool unsupported = false;   ///< it lacks what the scene needs: no failure
  std::size_t hits = 0;       ///< of the gas, by which it is judged: those up to `until`
  std::uint64_t steps = 0;
  double latest = 0;  ///< of the hits before it parted: how many steps after the hit an answer was seen at the latest
  std::optional<WrongHit> wrong;
};

/// The steps of the engine are compared with the gas. An engine's velocity is read as the nearest whole ones, so that
/// no rounding matters; when a hit is answered does not matter either, only what follows what: at the end of each step
/// a cube has the velocity that it had, or the one after its next hit in the gas. Several of its hits may fall between
/// two readings if they are less than two steps apart: an engine that looks for contacts where bodies are at the start
/// of a step answers a hit at the end of the next, with the hits of that step. The engine makes twice the steps that
/// the gas needs, so that whoever is late has time to answer. Throws GasError.
Verdict referee(const GasScene& gas, std::unique_ptr<EngineLines> lines, const std::string& command);

/// One line.
std::string sentence_of(const GasScene& gas, const Verdict& verdict);

}  // namespace touchstone::simulate::gas
