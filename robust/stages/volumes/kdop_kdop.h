// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/kdop_kdop.h"

namespace touchstone::robust::stages {

/// The filter looks at differences of all slabs, the exact stage compares the bits as integers; there is no lattice.
struct kdop_kdop {
  static Perhaps<Contact> filter(const Kdop3d& a, const Kdop3d& b);
  static Contact exact(const Kdop3d& a, const Kdop3d& b);
  static Decided<Contact> ask(const Kdop3d& a, const Kdop3d& b);
};

}  // namespace touchstone::robust::stages
