// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/quadtree.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct quadtree : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::quadtree(q...); }

  static constexpr Metadata metadata = broad_phase::metadata.implementation(
      {.name = "quadtree",
       .pages = "62",
       .question = "Which of these boxes meet each other, a box, a point or a ray, by a quadtree?",
       .cost = 20,
       .time = by_structure});

  /// The tree is one over x and y: so is its picture.
  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::Quadtree<double>>(drawing, {"quadtree", "cell", "cells"}, question, truth);
    seen_from_above(drawing);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
