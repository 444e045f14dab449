// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "geometry/answers.h"
#include "geometry/volumes.h"

/// Oriented boxes by unit axes and half lengths, as programs keep them. Contracts: reference/volumes/obb_obb.h,
/// reference/volumes/point_in_obb.h. In exact arithmetic both are right where the half axes are at right angles.
namespace touchstone::reference::standard {

template <class Real>
struct UnitAxes {
  std::array<Vector3<Real>, 3> axes;
  std::array<Real, 3> lengths;

  explicit UnitAxes(const HalfAxes<Real>& half_axes) : axes{half_axes.u, half_axes.v, half_axes.w} {
    using std::sqrt;
    for (std::size_t i = 0; i < 3; ++i) {
      lengths[i] = Real(sqrt(dot(axes[i], axes[i])));
      axes[i] = {Real(axes[i].x / lengths[i]), Real(axes[i].y / lengths[i]), Real(axes[i].z / lengths[i])};
    }
  }
};

template <class Real>
Real size_of(const Real& x) {
  return x < Real(0) ? Real(-x) : x;
}

/// In the first box's frame (Gottschalk, Lin and Manocha, OBBTree, 1996): nine cosines between the axes serve all 15
/// separating axes.
template <class Real>
Contact obb_obb(const Obb3<Real>& first, const Obb3<Real>& second) {
  const UnitAxes<Real> a(first.half_axes), b(second.half_axes);
  const Vector3<Real> displacement = second.center - first.center;
  std::array<Real, 3> t;
  std::array<std::array<Real, 3>, 3> cosine, size;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = dot(displacement, a.axes[i]);
    for (std::size_t j = 0; j < 3; ++j) cosine[i][j] = dot(a.axes[i], b.axes[j]), size[i][j] = size_of(cosine[i][j]);
  }
  bool touching = false;
  const auto separates = [&](const Real& along, const Real& reach) {
    const Real distance = size_of(along);
    if (distance == reach && reach > Real(0)) touching = true;
    return distance > reach;
  };
  const auto reach_of = [](const std::array<Real, 3>& lengths, const Real& x, const Real& y, const Real& z) {
    return Real(Real(lengths[0] * x + lengths[1] * y) + lengths[2] * z);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (separates(t[i], Real(a.lengths[i] + reach_of(b.lengths, size[i][0], size[i][1], size[i][2]))))
      return Contact::disjoint;
    const Real along = Real(Real(t[0] * cosine[0][i] + t[1] * cosine[1][i]) + t[2] * cosine[2][i]);
    if (separates(along, Real(reach_of(a.lengths, size[0][i], size[1][i], size[2][i]) + b.lengths[i])))
      return Contact::disjoint;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Real of_a = Real(a.lengths[i1] * size[i2][j] + a.lengths[i2] * size[i1][j]),
                 of_b = Real(b.lengths[j1] * size[i][j2] + b.lengths[j2] * size[i][j1]);
      if (separates(Real(t[i2] * cosine[i1][j] - t[i1] * cosine[i2][j]), Real(of_a + of_b))) return Contact::disjoint;
    }
  }
  return touching ? Contact::touching : Contact::overlapping;
}

template <class Real>
Location point_in_obb(const Obb3<Real>& obb, const Point3<Real>& point) {
  const UnitAxes<Real> box(obb.half_axes);
  const Vector3<Real> displacement = point - obb.center;
  bool on = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real distance = size_of<Real>(dot(displacement, box.axes[i]));
    if (distance > box.lengths[i]) return Location::outside;
    if (distance == box.lengths[i]) on = true;
  }
  return on ? Location::boundary : Location::inside;
}

}  // namespace touchstone::reference::standard
