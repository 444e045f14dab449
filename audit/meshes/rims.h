// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "audit/meshes/surface.h"

namespace touchstone::audit::meshes {

/// Open edges that are connected.
struct Rim {
  std::vector<std::size_t> edges;  ///< indices in the list of open edges, ascending
  double length = 0;               ///< in double arithmetic
};

/// In the order of their first edges.
std::vector<Rim> rims_of(const std::vector<EdgeOfFile>& open, const std::vector<Point3d>& vertices);

/// A vertex that lies within an edge of a face that does not contain it.
struct TJunction {
  Index vertex;
  EdgeOfFile edge;
};

/// For a rim whose vertices are collinear, exactly, a vertex within an edge of it: the place to split a face. nullopt
/// if they are not collinear.
std::optional<TJunction> t_junction(const Rim& rim, const std::vector<EdgeOfFile>& open,
                                    const std::vector<Point3d>& vertices);

}  // namespace touchstone::audit::meshes
