// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulate/recording.h"

namespace touchstone::report {

/// A self-contained page that plays the runs of a scene side by side (player.js): positions, velocities and contacts,
/// energy, drift and momentum, the distance of runs from one another, and where they diverge. If there are more than
/// 2,000 steps, every second, third ... is shown. The same recording gives the same bytes.
std::string simulation_page(const simulate::Recording& recording);

/// The input of player.js.
simulate::Json player_data(const simulate::Recording& recording);

}  // namespace touchstone::report
