// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/space.h"

namespace touchstone {

/// Three places in a list of vertices, counter-clockwise as seen from outside.
struct Face {
  Index a, b, c;
  friend bool operator==(const Face&, const Face&) = default;
};

/// Triangles over a list of vertices, as a surface in space. A face that names a vertex which is not there is refused.
template <class Real>
struct Mesh {
  std::vector<Point3<Real>> vertices;
  std::vector<Face> faces;
};

using Meshd = Mesh<double>;

}  // namespace touchstone
