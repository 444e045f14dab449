// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/world/step.h"

/// What is said to an engine that makes the steps of a scene, and what it answers (docs/simulate.md).
namespace touchstone::simulate {

/// What a scene may need and an engine may lack.
inline const std::vector<const char*> engine_features{"particles", "spheres", "boxes",   "walls",
                                                      "fixed",     "stick",   "penalty", "space"};

/// The first line of an engine.
struct EngineHello {
  std::string engine;  ///< its name and version
  bool binary32 = false;
  std::vector<std::string> cannot;      ///< of the features
  std::vector<std::string> thresholds;  ///< documented, and not switched off: what they do is no error
  std::string unsupported;              ///< why it cannot run this scene, in its own words; empty if it can
};

/// What it answered for one step.
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

/// What the scene needs and the engine lacks, with commas, or what it says itself; empty if nothing.
std::string lacking(const EngineHello& hello, const Scene& scene);

/// Whether all that moves stays in the plane z = 0.
bool is_planar(const Scene& scene);

}  // namespace touchstone::simulate
