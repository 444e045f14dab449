// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/points.h"
#include "geometry/polygons.h"
#include "geometry/space.h"

namespace touchstone {

/// The closed box of points with min <= p <= max in each coordinate. min == max in one of them is valid: a flat box,
/// which has no interior. min > max is refused.
template <class Real>
struct Aabb2 {
  Point2<Real> min, max;
};
template <class Real>
struct Aabb3 {
  Point3<Real> min, max;
};

/// The closed ball |p - center| <= radius. Radius 0 is valid (a point, which has no interior); a negative radius is
/// refused.
template <class Real>
struct Sphere3 {
  Point3<Real> center;
  Real radius;
};

/// The points center + r u + s v + t w with r, s, t in [-1, 1], where u, v, w are the half axes. They need be neither
/// orthogonal nor of any length: the solid is a parallelepiped. Linearly dependent ones are refused.
template <class Real>
struct HalfAxes {
  Vector3<Real> u, v, w;
};
template <class Real>
struct Obb3 {
  Point3<Real> center;
  HalfAxes<Real> half_axes;
};

/// The numbers d with min <= d <= max. min == max is valid, min > max is refused.
template <class Real>
struct Slab {
  Real min, max;
  friend bool operator==(const Slab&, const Slab&) = default;
};

/// The points p with min <= normal . p <= max for every normal and its slab. Normals have any length but 0, which is
/// refused; so are a list without normals and lists of different lengths. The solid may be empty, or unbounded.
template <class Real>
struct Kdop3 {
  std::vector<Vector3<Real>> normals;
  std::vector<Slab<Real>> slabs;
};

/// How a ball around points is found: around the center of their box or around their centroid, by growing it from a
/// wide pair (Ritter), or the smallest of all.
enum class SphereMethod { box, centroid, ritter, smallest };

/// The places of two elements of one list.
struct IndexPair {
  Index i, j;
  friend bool operator==(const IndexPair&, const IndexPair&) = default;
};

using Aabb2d = Aabb2<double>;
using Aabb3d = Aabb3<double>;
using Sphere3d = Sphere3<double>;
using Obb3d = Obb3<double>;
using Slabd = Slab<double>;
using Kdop3d = Kdop3<double>;

}  // namespace touchstone
