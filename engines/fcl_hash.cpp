// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its table of hashed cells.
#include <fcl/config.h>

#include "engines/fcl_manager.h"
#include "program/engine_main.h"

using namespace touchstone;

struct FclHash : fcl_manager::Engine<fcl::SpatialHashingCollisionManagerd<>> {
  static constexpr const char* name = "FCL " FCL_VERSION " (SpatialHashingCollisionManager)";
};

TOUCHSTONE_ENGINE_MAIN(FclHash)
