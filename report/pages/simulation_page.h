// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulate/recording.h"

namespace touchstone::report {

/// A page that stands alone and plays the runs of a scene side by side (player.js): positions, velocities and contacts,
/// energy, drift and momentum, how far runs are from one another, and where they part. Of more than 2,000 steps every
/// second, third ... is shown. Same recording, same bytes.
std::string simulation_page(const simulate::Recording& recording);

/// What player.js is given.
simulate::Json player_data(const simulate::Recording& recording);

}  // namespace touchstone::report
