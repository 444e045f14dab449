// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/commands.h"

namespace touchstone::catalogue::signatures {

struct broad_phase {
  TOUCHSTONE_SIGNATURE(broad_phase)
  using Boxes = std::vector<Aabb3d>;
  using Commands = std::vector<Commandd>;
  using Question = std::tuple<Boxes, Commands>;
  using Answer = std::vector<std::variant<PairsReply, BodiesReply, RayReply>>;
};

}  // namespace touchstone::catalogue::signatures
