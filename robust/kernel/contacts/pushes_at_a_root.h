// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robust/kernel/integers/one_root.h"

namespace touchstone::robust::kernel {

/// Impulses x >= 0 with A x >= r, each 0 or its row met without a surplus, as in contact_system.h, over one root: A is
/// how the impulse of one contact parts another, r what is wanted. There are such impulses.
struct PushesAtARoot {
  std::vector<std::vector<OneRoot>> effects;
  std::vector<OneRoot> wanted;
};

/// The dual active-set method of contact_system.h (Goldfarb, Idnani), from no contact that pushes.
std::vector<OneRoot> impulses_of(const PushesAtARoot& program);

}  // namespace touchstone::robust::kernel
