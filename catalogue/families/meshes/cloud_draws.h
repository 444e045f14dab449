// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "geometry/space.h"

/// Clouds of points in space, drawn from a draw stream: those that are hard for hulls, and for all that is built
/// around points.
namespace touchstone::catalogue {

struct Cloud {
  const char* name;
  std::vector<Point3d> (*draw)(DrawStream&);
};

inline constexpr std::size_t cloud_count = 22;
const std::array<Cloud, cloud_count>& all_clouds();

}  // namespace touchstone::catalogue
