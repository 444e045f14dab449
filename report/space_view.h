// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/space_model.h"
#include "report/viewport.h"

/// A model of space on paper: orthographic, y up. The page's script (space_script.h) draws the same from the same
/// numbers when the reader turns the scene; whoever changes one of the two changes the other.
namespace touchstone::audit {

/// Turned about the vertical axis, then towards the reader. Fractions p/q and not angles, so that every machine has
/// the same.
struct Turn {
  int cos_yaw, sin_yaw, yaw_over, cos_pitch, sin_pitch, pitch_over;
};
constexpr Turn first_turn{15, 8, 17, 12, 5, 13};

struct SpaceFrame {
  Frame frame;
  double room;  ///< pixels from the middle to the farthest point
};
constexpr SpaceFrame space_frame{{400, 300}, 134};

/// Everything that turns, as SVG, from the farthest to the nearest.
std::string turned(const SpaceModel& model, const Turn& turn);

/// The model in one line, for the script: records between semicolons.
std::string model_data(const SpaceModel& model, const Turn& turn);

}  // namespace touchstone::audit
