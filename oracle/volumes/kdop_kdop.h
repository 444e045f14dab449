// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: of each pair of slabs four differences of a max and a min, each max with each min: two are the widths, two
/// say how far one slab reaches beyond the other's beginning. The least of all of them, in rationals, is negative where
/// some pair has no number in common, and 0 if, failing that, some pair has no interval in common. Margin: its size.
///
/// Certificate: disjoint: "separating_slab" (`slab`, a `value` between both). touching: `values`, one that both slabs
/// hold for each normal, and the `slab` that has no other: "touching_slab". overlapping: "common_values" (`values`
/// strictly within both slabs, for each normal).
template <Exact Number = double>
Truth<Contact> kdop_kdop(const Kdop3<Number>& a, const Kdop3<Number>& b);

}  // namespace touchstone::oracle
