// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/bsp_tree.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct bsp_tree : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::bsp_tree(q...); }

  static constexpr Metadata metadata = broad_phase::metadata.implementation(
      {.name = "bsp_tree",
       .pages = "63",
       .question = "Which of these boxes meet each other, a box, a point or a ray, by a tree of planes?",
       .cost = 6,
       .time = by_structure});

  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::PlaneTree<double>>(drawing, {"tree of planes", "node", "nodes"}, question, truth);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
