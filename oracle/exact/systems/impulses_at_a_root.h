// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/numbers/over_root.h"

namespace touchstone::oracle {

/// What each contact's impulse does to how fast each other one parts, and how much each must be changed at least.
struct ImpulsesWanted {
  std::vector<std::vector<OverRoot>> effects;
  std::vector<OverRoot> demands;
};

/// Impulses that are not negative, meet every demand, and exceed none where they are not 0. All numbers are over one
/// root. Every set of contacts that push is a system of equations; those that numbers of 1,024 bits find right are
/// solved exactly first, and what decides is the exact solution. std::logic_error where there is none.
std::vector<OverRoot> impulses_at_a_root(const ImpulsesWanted& wanted);

}  // namespace touchstone::oracle
