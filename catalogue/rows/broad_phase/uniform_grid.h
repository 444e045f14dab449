// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/uniform_grid.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct uniform_grid : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::uniform_grid(q...); }

  static constexpr Metadata metadata = broad_phase::metadata.implementation(
      {.name = "uniform_grid",
       .pages = "62",
       .question = "Which of these boxes meet each other, a box, a point or a ray, by a uniform grid?",
       .cost = 3,
       .time = by_structure});

  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::Grid<double>>(drawing, {"uniform grid", "cell", "cells"}, question, truth);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
