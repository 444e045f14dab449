// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/obb_obb.h"

namespace touchstone::robust::stages {

struct obb_obb {
  static Perhaps<Contact> filter(const Obb3d& a, const Obb3d& b);
  static Perhaps<Contact> lattice(const Obb3d& a, const Obb3d& b);
  static Contact exact(const Obb3d& a, const Obb3d& b);
  static Decided<Contact> ask(const Obb3d& a, const Obb3d& b);
};

}  // namespace touchstone::robust::stages
