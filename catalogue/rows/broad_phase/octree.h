// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/octree.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct octree : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::octree(q...); }

  static const Metadata& metadata() {
    static const Metadata metadata = [] {
      Metadata other = broad_phase::metadata();
      other.name = "octree";
      other.pages = "62";
      other.question = "Which of these boxes meet each other, a box, a point or a ray, by an octree?";
      other.implementation_of = "broad_phase";
      other.cost = 40;  // in exact arithmetic it is made anew for each query
      other.time = {.robust = Growth::quadratic,
                    .oracle = Growth::quadratic,
                    .ask = Growth::quadratic,
                    .reference = Growth::quadratic_log};
      return other;
    }();
    return metadata;
  }

  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::Octree<double>>(drawing, {"octree", "cell", "cells"}, question, truth);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
