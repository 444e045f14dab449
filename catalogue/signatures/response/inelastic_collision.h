// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_bodies.h"
#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct inelastic_collision {
  TOUCHSTONE_SIGNATURE(inelastic_collision)
  using Question = std::tuple<Massesd, Velocitiesd>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
