// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its trees of intervals.
#include <fcl/config.h>
#include <touchstone/program/engine_main.h>

#include "fcl_manager.h"

using namespace touchstone;

struct FclIntervals : fcl_manager::Engine<fcl::IntervalTreeCollisionManagerd> {
  static constexpr const char* name = "FCL " FCL_VERSION " (IntervalTreeCollisionManager)";
};

TOUCHSTONE_ENGINE_MAIN(FclIntervals)
