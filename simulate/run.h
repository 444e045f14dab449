// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <ostream>

#include "simulate/scene.h"

namespace touchstone::simulate {

/// Runs a scene in float, in double and by robust, and writes a line of JSON for the start and for each step:
/// {"step":0,"float":[{"position":[..],"velocity":[..]}],"double":[..],"robust":[..]}.
void run(const Scene& scene, std::uint64_t steps, std::ostream& out);

}  // namespace touchstone::simulate
