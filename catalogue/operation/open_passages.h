// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "catalogue/operation/row.h"
#include "geometry/rays.h"

namespace touchstone::catalogue {

/// The hook `as_open_sets` of a line and a solid: a line without its ends that only grazes a solid without its boundary
/// never meets it, and a solid without an interior is empty then.
template <class Row>
std::optional<truth_t<Row>> none_if_grazing(const truth_t<Row>& truth, const typename Row::Question& question) {
  if (truth.relation != PassageRelation::hit) return std::nullopt;
  const bool open = std::visit([](const auto& q) { return Row::has_interior(std::get<1>(q)); }, question);
  if (open && sgn(*ask_oracle<Row>(question).margin) != 0) return std::nullopt;
  return truth_t<Row>{PassageRelation::none, {}, {}};
}

}  // namespace touchstone::catalogue
