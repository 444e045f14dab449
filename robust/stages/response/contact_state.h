// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/contact_state.h"

namespace touchstone::robust::stages {

struct contact_state : detail::contact_state {
  static Perhaps<ContactState> lattice(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point,
                                       const Vector3d& normal);
  static ContactState exact(const MovingBodyd& a, const MovingBodyd& b, const Point3d& point, const Vector3d& normal);
};

}  // namespace touchstone::robust::stages
