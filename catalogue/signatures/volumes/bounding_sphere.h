// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct bounding_sphere {
  TOUCHSTONE_SIGNATURE(bounding_sphere)
  /// The method may be left out.
  using Method = std::optional<SphereMethod>;
  using Question = std::tuple<std::vector<Point3d>, Method>;
  using Answer = Sphere3<double>;
};

}  // namespace touchstone::catalogue::signatures
