// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/octree.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct octree : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::octree(q...); }

  static constexpr Metadata metadata = broad_phase::metadata.implementation(
      {.name = "octree",
       .pages = "62",
       .question = "Which of these boxes meet each other, a box, a point or a ray, by an octree?",
       .cost = 40,
       .time = by_structure});

  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::Octree<double>>(drawing, {"octree", "cell", "cells"}, question, truth);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
