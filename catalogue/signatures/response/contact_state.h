// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct contact_state {
  TOUCHSTONE_SIGNATURE(contact_state)
  using Question = std::tuple<MovingBodyd, MovingBodyd, Point3d, Vector3d>;
  using Answer = ContactState;
};

}  // namespace touchstone::catalogue::signatures
