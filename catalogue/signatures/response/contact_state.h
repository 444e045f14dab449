// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_bodies.h"
#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct contact_state {
  TOUCHSTONE_SIGNATURE(contact_state)
  using Question = std::tuple<MovingBodyd, MovingBodyd, Point3d, Vector3d>;
  using Answer = ContactState;
};

}  // namespace touchstone::catalogue::signatures
