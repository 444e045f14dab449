// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct contact_state : Signature<ContactState(MovingBodyd, MovingBodyd, Point3d, Vector3d)> {
  TOUCHSTONE_SIGNATURE(contact_state)
};

}  // namespace touchstone::catalogue::signatures
