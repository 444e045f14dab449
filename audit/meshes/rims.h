// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "audit/meshes/surface.h"

namespace touchstone::audit::meshes {

/// Open edges that are connected.
struct Rim {
  std::vector<std::size_t> edges;  ///< places in the list of open edges, ascending
  double length = 0;               ///< in double arithmetic
};

/// In the order of their first edges.
std::vector<Rim> rims_of(const std::vector<EdgeOfFile>& open, const std::vector<Point3d>& vertices);

/// A vertex that lies within an edge of a face which does not name it.
struct TJunction {
  Index vertex;
  EdgeOfFile edge;
};

/// Of a rim whose vertices lie on one line, exactly, one within an edge of it: where a face has to be split. Empty
/// where they do not.
std::optional<TJunction> t_junction(const Rim& rim, const std::vector<EdgeOfFile>& open,
                                    const std::vector<Point3d>& vertices);

}  // namespace touchstone::audit::meshes
