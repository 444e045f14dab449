// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"

namespace touchstone {

/// Of which dimension the common part of two triangles is.
enum class TriangleTriangleRelation { none, point, segment, area };

}  // namespace touchstone
