// SPDX-License-Identifier: Apache-2.0
// libccd as peer: depth by Minkowski portal refinement (MPR), documented as a depth and not as the least one.
#include <touchstone/program/engine_main.h>

#include "ccd_solids.h"

using namespace touchstone;

struct CcdMpr {
  static constexpr const char* name = "libccd 2.1 (MPR)";

  std::optional<Penetration<double>> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
    return ccd_solids::penetration(ccdMPRPenetration, a, b, radius_a, radius_b);
  }
};

TOUCHSTONE_ENGINE_MAIN(CcdMpr)
