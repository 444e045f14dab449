// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// How many cases of an operation are asked where so many are to be asked of each: `by_cost`, of one that costs more
/// than ten of the cheapest so many fewer as it costs more, but 100 at least.
inline std::uint64_t cases_of(const Operation& operation, std::uint64_t cases, bool by_cost) {
  const auto cost = static_cast<std::uint64_t>(operation.metadata().cost);
  if (!by_cost || cost <= 10) return cases;
  return std::min(cases, std::max<std::uint64_t>(100, 10 * cases / cost));
}

}  // namespace touchstone::audit
