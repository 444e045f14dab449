// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/broad_phase/broad_phase.h"
#include "reference/broad_phase/bounding_volume_hierarchy.h"
#include "robust/broad_phase/bounding_volume_hierarchy.h"

namespace touchstone::catalogue::rows {

/// Another structure for the same question.
struct bounding_volume_hierarchy : broad_phase {
  static auto reference(const auto&... q) { return ::touchstone::reference::bounding_volume_hierarchy(q...); }
  static auto robust(const auto&... q) { return ::touchstone::robust::bounding_volume_hierarchy(q...); }

  static constexpr Metadata metadata = broad_phase::metadata.implementation(
      {.name = "bounding_volume_hierarchy",
       .pages = "58-61",
       .question = "Which of these boxes meet each other, a box, a point or a ray, by a hierarchy of boxes?",
       .cost = 4,
       .time = by_structure});

  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    draw_in<::touchstone::reference::BoxHierarchy<double>>(drawing, {"hierarchy of boxes", "node", "nodes"}, question,
                                                           truth);
  }
  static Hooks<broad_phase> hooks() { return drawn_by(draw); }
};

}  // namespace touchstone::catalogue::rows
