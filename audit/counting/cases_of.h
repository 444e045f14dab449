// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The number of cases of an operation, out of those requested for each: with `by_cost`, an operation that costs more
/// than ten times the cheapest gets fewer in proportion, but at least 100.
inline std::uint64_t cases_of(const Operation& operation, std::uint64_t cases, bool by_cost) {
  const auto cost = static_cast<std::uint64_t>(operation.metadata().cost);
  if (!by_cost || cost <= 10) return cases;
  return std::min(cases, std::max<std::uint64_t>(100, 10 * cases / cost));
}

}  // namespace touchstone::audit
