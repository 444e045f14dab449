// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "catalogue/operation/row.h"
#include "geometry/closest.h"

/// The hook `as_open_sets` of most rows: the answer for open sets if closed ones only touch; `as_near` of two rows; and
/// all hooks of rows that decide the contact of two solids, one or both of which have a radius.
namespace touchstone::catalogue {

/// Open shapes that touch are disjoint.
template <class Question>
std::optional<Contact> disjoint_if_touching(const Contact& truth, const Question&) {
  if (truth != Contact::touching) return std::nullopt;
  return Contact::disjoint;
}

/// An open shape does not have its boundary.
template <class Question>
std::optional<Location> outside_if_on_boundary(const Location& truth, const Question&) {
  if (truth != Location::boundary) return std::nullopt;
  return Location::outside;
}

/// Open shapes that only graze each other during the step, or touch at the start and separate, or at the last moment,
/// never meet. Then the margin is 0.
template <class Row>
std::optional<truth_t<Row>> never_if_grazing(const truth_t<Row>& truth, const typename Row::Question& question) {
  if (truth.relation != HitRelation::hit) return std::nullopt;
  const auto margin = ask_oracle<Row>(question).margin;
  if (!margin || sgn(*margin) != 0) return std::nullopt;
  return truth_t<Row>{HitRelation::never, {}};
}

/// Open solids that only touch have the distance 0; the nearest points are undefined.
template <class Row>
std::optional<truth_t<Row>> apart_if_touching(const truth_t<Row>& truth, const typename Row::Question& question) {
  if (truth.relation != ConvexRelation::meeting) return std::nullopt;
  const auto margin = ask_oracle<Row>(question).margin;
  if (!margin || sgn(*margin) != 0) return std::nullopt;
  return truth_t<Row>{ConvexRelation::apart, {}, {}, {}, {}};
}

/// The hook `as_near` of two convex shapes: there is another answer where both truth and answer have points.
template <class Row>
std::optional<truth_t<Row>> as_near_to_answer(const typename Row::Question& question, const truth_t<Row>& truth,
                                              const ConvexDistance<double>& answer) {
  const auto& [a, b] = question;
  if (!truth.on_a || !answer.on_a) return std::nullopt;
  return as_near(a, b, truth, *answer.on_a);
}

/// Radii lose their sign.
template <class Question>
void repair_radii(Question& question) {
  const auto repair = [](auto& solid) {
    if constexpr (requires { solid.radius; }) solid.radius = std::fabs(solid.radius);
  };
  std::apply([&repair](auto&... solid) { (repair(solid), ...); }, question);
}

template <class Row>
Hooks<Row> hooks_of_round_pair(std::vector<Laws::Exchange> exchanges = {}) {
  using Question = typename Row::Question;
  return {.as_open_sets = disjoint_if_touching<Question>,
          .repair = repair_radii<Question>,
          .map_centre = Row::map_centre,
          .map_axes = Row::map_axes,
          .laws = {.maps = Laws::Maps::similarities, .scales = true, .exchanges = std::move(exchanges)}};
}

}  // namespace touchstone::catalogue
