// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_polygon {
  TOUCHSTONE_SIGNATURE(polygon_polygon)
  using Question = std::tuple<Polygon2d, Polygon2d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
