// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_polygon : Signature<Contact(Polygon2d, Polygon2d)> {
  TOUCHSTONE_SIGNATURE(polygon_polygon)
};

}  // namespace touchstone::catalogue::signatures
