// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_convex_polyhedra {
  TOUCHSTONE_SIGNATURE(swept_convex_polyhedra)
  using Question = std::tuple<Meshd, Meshd, Vector3d>;
  using Answer = FirstContact<double>;
};

}  // namespace touchstone::catalogue::signatures
