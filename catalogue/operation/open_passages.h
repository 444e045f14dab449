// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "catalogue/operation/row.h"
#include "geometry/rays.h"

namespace touchstone::catalogue {

/// The hook `as_open_sets` of a line and a plane: a segment without its ends, a ray without its origin. A line without
/// length is then empty.
template <class Row>
std::optional<LinePlane<mpq_class>> without_ends(const LinePlane<mpq_class>& truth, const typename Row::Question& q) {
  const LinePlane<mpq_class> none{LinePlaneRelation::none, std::nullopt, std::nullopt};
  if (truth.relation == LinePlaneRelation::inside) return Row::has_length(q) ? std::nullopt : std::optional(none);
  const bool at_end = truth.t && (sgn(*truth.t) == 0 || (Row::ends && *truth.t == 1));
  return at_end ? std::optional(none) : std::nullopt;
}

/// The hook `as_open_sets` of a line and a solid: a line without its ends that only grazes a solid without its boundary
/// never meets it, and a solid without an interior is empty then.
template <class Row>
std::optional<truth_t<Row>> none_if_grazing(const truth_t<Row>& truth, const typename Row::Question& question) {
  if (truth.relation != PassageRelation::hit) return std::nullopt;
  const bool open = applied([](const auto&, const auto& solid) { return Row::has_interior(solid); }, question);
  if (open && sgn(*ask_oracle<Row>(question).margin) != 0) return std::nullopt;
  return truth_t<Row>{PassageRelation::none, {}, {}};
}

}  // namespace touchstone::catalogue
