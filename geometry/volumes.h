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
  static constexpr auto members = as_record("min", "max");
  bool rules(const auto& check) const {
    return check({"max", 0}, rule::interval(min.x, max.x)) && check({"max", 1}, rule::interval(min.y, max.y));
  }
};
template <class Real>
struct Aabb3 {
  Point3<Real> min, max;
  static constexpr auto members = as_record("min", "max");
  bool rules(const auto& check) const {
    return check({"max", 0}, rule::interval(min.x, max.x)) && check({"max", 1}, rule::interval(min.y, max.y)) &&
           check({"max", 2}, rule::interval(min.z, max.z));
  }
};

/// The closed ball |p - center| <= radius. Radius 0 is valid (a point, which has no interior); a negative radius is
/// refused.
template <class Real>
struct Sphere3 {
  Point3<Real> center;
  Real radius;
  static constexpr auto members = as_record("center", "radius").of(Meaning::length);
  bool rules(const auto& check) const { return check("radius", rule::radius(radius)); }
};

/// The points center + r u + s v + t w with r, s, t in [-1, 1], where u, v, w are the half axes. They need be neither
/// orthogonal nor of any length: the solid is a parallelepiped. Linearly dependent ones are refused.
template <class Real>
struct HalfAxes {
  Vector3<Real> u, v, w;
  static constexpr auto members = as_list("u", "v", "w");
};
template <class Real>
struct Obb3 {
  Point3<Real> center;
  HalfAxes<Real> half_axes;
  static constexpr auto members = as_record("center", "half_axes");
  static constexpr rule::Exact independent{"half_axes", "linearly independent"};
};

/// The numbers d with min <= d <= max. min == max is valid, min > max is refused.
template <class Real>
struct Slab {
  Real min, max;
  static constexpr auto members = as_list("min", "max");
  bool rules(const auto& check) const { return check({"", 1}, rule::interval(min, max)); }
  friend bool operator==(const Slab&, const Slab&) = default;
};

/// The points p with min <= normal . p <= max for every normal and its slab. Normals have any length but 0, which is
/// refused; so are a list without normals and lists of different lengths. The solid may be empty, or unbounded.
template <class Real>
struct Kdop3 {
  std::vector<Vector3<Real>> normals;
  std::vector<Slab<Real>> slabs;
  static constexpr auto members = as_record("normals", "slabs");
  bool rules(const auto& check) const {
    if (!check("normals", rule::normals(normals))) return false;
    if (!check("slabs", {slabs.size() == normals.size(), "as many slabs as normals"})) return false;
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (!check({"normals", i}, rule::normal(normals[i])) || !check.part({"slabs", i}, slabs[i])) return false;
    return true;
  }
};

/// How a ball around points is found: around the center of their box or around their centroid, by growing it from a
/// wide pair (Ritter), or the smallest of all.
enum class SphereMethod { box, centroid, ritter, smallest };
constexpr auto words_of(SphereMethod) { return as_words("box", "centroid", "ritter", "smallest"); }

/// The places of two elements of one list.
struct IndexPair {
  Index i, j;
  static constexpr auto members = as_list("i", "j");
  friend bool operator==(const IndexPair&, const IndexPair&) = default;
};

using Aabb2d = Aabb2<double>;
using Aabb3d = Aabb3<double>;
using Sphere3d = Sphere3<double>;
using Obb3d = Obb3<double>;
using Slabd = Slab<double>;
using Kdop3d = Kdop3<double>;

}  // namespace touchstone
