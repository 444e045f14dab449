// SPDX-License-Identifier: Apache-2.0
// libccd as peer: depth by GJK and a polytope that expands (EPA).
#include <touchstone/program/engine_main.h>

#include "ccd_solids.h"

using namespace touchstone;

struct Ccd {
  static constexpr const char* name = "libccd 2.1 (GJK and EPA)";

  std::optional<Penetration<double>> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
    return ccd_solids::penetration(ccdGJKPenetration, a, b, radius_a, radius_b);
  }
};

TOUCHSTONE_ENGINE_MAIN(Ccd)
