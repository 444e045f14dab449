// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/world/step.h"

/// The messages to an engine that makes the steps of a scene, and its answers (docs/simulate.md).
namespace touchstone::simulate {

/// Features that a scene may need and an engine may lack.
inline const std::vector<const char*> engine_features{"particles", "spheres", "boxes",   "walls",
                                                      "fixed",     "stick",   "penalty", "space"};

/// The first line of an engine.
struct EngineHello {
  std::string engine;  ///< its name and version
  bool binary32 = false;
  std::vector<std::string> cannot;      ///< missing features
  std::vector<std::string> thresholds;  ///< documented, and not switched off: their effects are not errors
  std::string unsupported;              ///< the reason why it cannot run this scene, in its own words; empty if it can
};

/// The answer for one step.
struct EngineStep {
  State<double> state;
  std::vector<Impact> impacts;
  bool tells_contacts = false;
};

/// The scene with every default filled in, and the room as walls.
std::string engine_greeting(const Scene& scene);
std::string engine_question(std::uint64_t step);

/// Throw InvalidInput, which names the field and the rule.
EngineHello read_engine_hello(const std::string& line);
EngineStep read_engine_step(const std::string& line, const Scene& scene, std::uint64_t step);

/// The features that the scene needs and the engine lacks, separated by commas, or the engine's own reason; empty if
/// none.
std::string lacking(const EngineHello& hello, const Scene& scene);

/// True if everything that moves stays in the plane z = 0.
bool is_planar(const Scene& scene);

}  // namespace touchstone::simulate
