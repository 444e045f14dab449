// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct all_pairs {
  TOUCHSTONE_SIGNATURE(all_pairs)
  using Spheres = std::vector<Sphere3d>;
  using Boxes = std::vector<Aabb3d>;
  using Question = std::variant<std::tuple<Spheres>, std::tuple<Boxes>>;
  using Answer = std::vector<IndexPair>;
};

}  // namespace touchstone::catalogue::signatures
