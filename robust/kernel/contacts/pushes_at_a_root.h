// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robust/kernel/integers/one_root.h"

namespace touchstone::robust::kernel {

/// Impulses x >= 0 with A x >= r, where each is 0 or its row holds with equality, as in contact_system.h, over one
/// root: A tells how much the impulse of one contact separates another, r is the demand. Such impulses exist.
struct PushesAtARoot {
  std::vector<std::vector<OneRoot>> effects;
  std::vector<OneRoot> wanted;
};

/// The dual active-set method of contact_system.h (Goldfarb, Idnani), started with no pushing contact.
std::vector<OneRoot> impulses_of(const PushesAtARoot& program);

}  // namespace touchstone::robust::kernel
