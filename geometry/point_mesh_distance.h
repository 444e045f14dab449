// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_mesh.h"
#include "geometry/words.h"

namespace touchstone {

/// A point of a mesh, the index of a face that has it, and the place of the point in the face.
template <class Real>
struct MeshPoint {
  Point3<Real> point;
  Index face;
  FacePart part;
  static constexpr auto members = as_record("point", "face", "part");
};

/// Where a point is relative to a solid, and the point of the surface nearest to it; signed_distance is negative
/// inside.
template <class Real>
struct PointMeshDistance {
  Location location;
  MeshPoint<Real> nearest;
  Real squared_distance, distance, signed_distance;
  static constexpr auto members = as_record("location", "nearest", "squared_distance", "distance", "signed_distance");
};

}  // namespace touchstone
