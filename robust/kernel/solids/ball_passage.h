// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "robust/kernel/filters/line_in_space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The first and the last t at which a line is in a ball: where f(t) = |p + t v|^2 - r^2 is at most 0, with p and v the
/// position and the direction of the line relative to the ball's center.
struct BallPassage {
  /// Returns `none` by the signs that sweep_filter.h proves, for a point that moves along the line; empty if the input
  /// is not valid.
  static Perhaps<Passage<double>> filter(const Line& line, const Ball& ball);
  /// Empty if the input is not valid.
  static Perhaps<Passage<double>> enclosed(const Line& line, const Ball& ball);
  static Passage<double> exact(const Line& line, const Ball& ball);
};

/// The first and the last t at which a valid line is in a valid capsule: the balls around its ends and the cylinder
/// between them. Each is convex, and so is the capsule: the earliest entry and the latest exit. Rounding is monotone,
/// so that these are the earliest and the latest of rounded ones.
struct CapsulePassage {
  /// Numbers are `moderate`.
  static Perhaps<Passage<double>> enclosed(const Line& line, const Capsule3d& capsule);
  static Passage<double> exact(const Line& line, const Capsule3d& capsule);
};

}  // namespace touchstone::robust::kernel
