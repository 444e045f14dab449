// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/numbers/over_root.h"

namespace touchstone::oracle {

/// The effect of each contact's impulse on the separating speed of every contact, and the required minimum change of
/// each.
struct ImpulsesWanted {
  std::vector<std::vector<OverRoot>> effects;
  std::vector<OverRoot> demands;
};

/// Impulses that are not negative, meet every demand, and exceed none where they are not 0. All numbers are over one
/// root. Every set of contacts that push is a system of equations; the sets that numbers of 1,024 bits find right are
/// solved exactly first, and the exact solution decides. Throws std::logic_error if there is none.
std::vector<OverRoot> impulses_at_a_root(const ImpulsesWanted& wanted);

}  // namespace touchstone::oracle
