// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulate/engine_run.h"
#include "simulate/gas/gas_scene.h"

/// An exact gas as the referee of an engine: finds the first hit that the engine answers differently.
namespace touchstone::simulate::gas {

/// The gas as a scene for engines: a metre is the side of a cube, and the greatest speed of the gas is 1 m/s; no
/// gravity, no loss, option 2. A planar gas lies in z = 0. Integers of the gas are exact in float as long as the side
/// and the speed are powers of 2 and coordinates have no more than 24 bits.
Scene scene_of(const GasScene& gas);

/// The history of a gas up to a time, cube by cube.
class Record {
 public:
  /// Throws GasError, also if a group of cubes made the unit of length smaller: velocities are no longer integers then.
  Record(const GasScene& gas, Int64 until);

  struct Turn {
    std::size_t hit;                  ///< its index in `hits`
    std::array<Int64, 3> velocity{};  ///< afterwards
  };
  const std::vector<Hit>& hits() const { return hits_; }
  /// The velocities of a cube, one after another, from the start.
  const std::vector<Turn>& turns(std::size_t cube) const { return turns_[cube]; }

 private:
  std::vector<Hit> hits_;
  std::vector<std::vector<Turn>> turns_;
};

/// The point at which an engine diverges from the gas.
struct WrongHit {
  std::size_t hit;                 ///< its index among the hits of the gas
  std::size_t cube;                ///< that revealed it
  std::uint64_t step;              ///< in which it was revealed
  std::array<double, 3> velocity;  ///< that it then had, in units of the gas
  bool missed;                     ///< it continued as before the hit; otherwise its velocity does not occur in the gas
};

struct Verdict {
  std::string engine, ended;  ///< the reason why it made no more steps; empty if it reached the end
  bool unsupported = false;   ///< it lacks a required feature: not a failure
  std::size_t hits = 0;       ///< of the gas, by which it is judged: those up to `until`
  std::uint64_t steps = 0;
  double latest = 0;  ///< over the hits before it diverged: the greatest delay of an answer, in steps
  std::optional<WrongHit> wrong;
};

/// Compares the steps of the engine with the gas. An engine's velocity is rounded to the nearest integers, so that its
/// rounding does not matter. The time at which a hit is answered does not matter either, only the order: at the end of
/// each step a cube has its previous velocity, or the one after its next hit in the gas. Several of its hits may fall
/// between two readings if they are less than two steps apart: an engine that looks for contacts at the start of a step
/// answers a hit at the end of the next, with the hits of that step. The engine makes twice the steps that the gas
/// needs, so that a late engine has time to answer. Throws GasError.
Verdict referee(const GasScene& gas, std::unique_ptr<EngineLines> lines, const std::string& command);

/// One line.
std::string sentence_of(const GasScene& gas, const Verdict& verdict);

}  // namespace touchstone::simulate::gas
