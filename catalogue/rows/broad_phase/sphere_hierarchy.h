// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/searches.h"
#include "catalogue/rows/broad_phase/all_pairs.h"
#include "reference/broad_phase/sphere_hierarchy.h"
#include "robust/broad_phase/sphere_hierarchy.h"

namespace touchstone::catalogue::rows {

/// A structure for the same question.
struct sphere_hierarchy : all_pairs {
  using stages = void;
  static auto reference(const auto&... q) { return ::touchstone::reference::sphere_hierarchy(q...); }
  static auto robust(const auto&... q) { return ::touchstone::robust::sphere_hierarchy(q...); }

  /// Its exact arithmetic has roots of thousands of digits.
  static constexpr Metadata metadata = all_pairs::metadata.implementation(
      {.name = "sphere_hierarchy",
       .pages = "58-61",
       .question = "Which of these balls, or boxes, meet, by a hierarchy of spheres?",
       .cost = 180,
       .time = grows(Growth::quadratic)});

  static void draw(Drawing& drawing, const Question& question, const Pairs& truth) {
    std::visit(
        [&](const auto& asked) {
          draw_in_balls(drawing, {"hierarchy of spheres", "node", "nodes"}, std::get<0>(asked), truth);
        },
        question);
  }
  static Hooks<all_pairs> hooks() {
    Hooks<all_pairs> own = all_pairs::hooks();
    own.draw = draw;
    return own;
  }
};

}  // namespace touchstone::catalogue::rows
