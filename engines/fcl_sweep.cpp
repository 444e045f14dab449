// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its sweep along three axes.
#include <fcl/config.h>
#include <touchstone/program/engine_main.h>

#include "fcl_manager.h"

using namespace touchstone;

struct FclSweep : fcl_manager::Engine<fcl::SaPCollisionManagerd> {
  static constexpr const char* name = "FCL " FCL_VERSION " (SaPCollisionManager)";
};

TOUCHSTONE_ENGINE_MAIN(FclSweep)
