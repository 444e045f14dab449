// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::robust::stages {

struct sphere_sphere : detail::sphere_sphere {
  static Perhaps<Contact> lattice(const Ball& a, const Ball& b);
  static Contact exact(const Ball& a, const Ball& b);
};

}  // namespace touchstone::robust::stages
