// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its dynamic tree of boxes.
#include <fcl/config.h>
#include <touchstone/program/engine_main.h>

#include "fcl_manager.h"

using namespace touchstone;

struct FclTree : fcl_manager::Engine<fcl::DynamicAABBTreeCollisionManagerd> {
  static constexpr const char* name = "FCL " FCL_VERSION " (DynamicAABBTreeCollisionManager)";
};

TOUCHSTONE_ENGINE_MAIN(FclTree)
