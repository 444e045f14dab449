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

  static const Metadata& metadata() {
    static const Metadata metadata = [] {
      Metadata other = all_pairs::metadata();
      other.name = "sphere_hierarchy";
      other.pages = "58-61";
      other.question = "Which of these balls, or boxes, meet, by a hierarchy of spheres?";
      other.implementation_of = "all_pairs";
      other.cost = 180;  // its exact arithmetic has roots of thousands of digits
      other.time = grows(Growth::quadratic);
      return other;
    }();
    return metadata;
  }

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
