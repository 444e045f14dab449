// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "robust/kernel/filters/face_filter.h"

/// The first stage for rays and triangles in space.
namespace touchstone::robust::filters {

/// The sign of ((b - a) x (c - a)) . d for a displacement d: positive if d leads to the side from which a, b, c are
/// seen counter-clockwise.
///
/// This is E of FacePlane with d instead of p - a, which is rounded there and exact here. So each product has one
/// rounding less and one absolute term less, that of a flushed difference, and the same factors and guards. Bound and
/// guard of FacePlane hold with room to spare. Not proved by machine.
template <class Float, class Format = FloatFormat<Float>>
Sign rise(const Point3<Float>& a, const Point3<Float>& b, const Point3<Float>& c, const Vector3<Float>& d) {
  using B = CubicBounds<Float, Format>;
  const auto sizes = [](const Vector3<Float>& v) {
    return Vector3<Float>{Format::magnitude(v.x), Format::magnitude(v.y), Format::magnitude(v.z)};
  };
  const Vector3<Float> v = b - a, w = c - a, x = sizes(v), y = sizes(w), z = sizes(d);
  const Float terms = (x.y * y.z + x.z * y.y) * z.x + (x.z * y.x + x.x * y.z) * z.y + (x.x * y.y + x.y * y.x) * z.z;
  const Float extent = (x.x + x.y + x.z) + (y.x + y.y + y.z) + (z.x + z.y + z.z);
  const Float error = Bounds<Float, Format>::template relative<14, 176>() * terms + B::absolute();
  return certain<Float, Format>(dot(cross(v, w), d), error, extent, B::high());
}

}  // namespace touchstone::robust::filters
