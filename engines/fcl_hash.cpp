// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its table of hashed cells.
#include <fcl/config.h>
#include <touchstone/program/engine_main.h>

#include "fcl_manager.h"

using namespace touchstone;

struct FclHash : fcl_manager::Engine<fcl::SpatialHashingCollisionManagerd<>> {
  static constexpr const char* name = "FCL " FCL_VERSION " (SpatialHashingCollisionManager)";
};

TOUCHSTONE_ENGINE_MAIN(FclHash)
