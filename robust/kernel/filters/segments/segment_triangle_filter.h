// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "robust/kernel/filters/face_filter.h"

/// The first stage for segments against triangles in space: the model, the guards and the rules of filters.h.
namespace touchstone::robust::filters {

/// The values of RayAndTriangle (ray_filter.h) for a segment from p to q, with v = q - p, s from a to p and t at p and
/// q. height is that at p over the triangle's plane, height - rise that at q.
///
/// One bound for ca, ab and bc: v is a computed difference here, so that a product of bc goes through ten roundings,
/// the last of which is shared (4), and at least (1 - u)^11 of the terms is computed; the bound has two operations
/// more. C (1 - u)^13 >= (1 + u) ((1 + u)^9 - 1) = 9 u + .... C = 9 u + 384 u^2: at u = 1/16, 1.785 < 2.062. The same C
/// for the two heights, in units of the products of `height` and of all the others together: through at most nine
/// roundings, the last of them shared, where at least (1 - u)^12 of the units is computed: at u = 1/16, 1.638.
///
/// Guard and absolute terms: as for RayAndTriangle, whose bound has them for a v that is read; a difference is off by 5
/// n, as those of FacePlane are, of which bc has three values, and height - rise two. Not proved by machine.
template <class Float, class Format = FloatFormat<Float>>
class SegmentAndTriangle {
 public:
  SegmentAndTriangle(const Segment3<Float>& segment, const Triangle3<Float>& triangle) {
    const auto& [p, q] = segment;
    const auto& [a, b, c] = triangle;
    const Vector3<Float> v = q - p, e = b - a, f = c - a, s = p - a, across = cross(v, f), turn = cross(s, e);
    const Float x = extent<Float, Format>(e.x, f.x, s.x), y = extent<Float, Format>(e.y, f.y, s.y),
                z = extent<Float, Format>(e.z, f.z, s.z), yz = y * z;
    const Float vx = Format::magnitude(v.x), vy = Format::magnitude(v.y), vz = Format::magnitude(v.z);
    const Float terms = vx * yz + vy * (z * x) + vz * (x * y);
    rise_ = dot(e, across), ca_ = dot(s, across), ab_ = dot(v, turn), height_ = dot(f, turn);
    beside_ = error(terms), over_ = error(terms + x * yz), size_ = x + y + z + vx + vy + vz;
  }

  Sign at_p() const { return sign(height_, over_); }
  Sign at_q() const { return sign(height_ - rise_, over_); }
  Sign beside_ca() const { return sign(ca_, beside_); }
  Sign beside_ab() const { return sign(ab_, beside_); }
  Sign beside_bc() const { return sign(rise_ - ca_ - ab_, beside_); }

 private:
  static Float error(const Float& terms) {
    const int h = Format::max_exponent / 4;
    const Float absolute = Format::above(power_of_two(10 + Format::min_exponent + 2 * h));
    return Bounds<Float, Format>::template relative<18, 384>() * terms + absolute;
  }
  Sign sign(const Float& value, const Float& error) const {
    return certain<Float, Format>(value, error, size_, CubicBounds<Float, Format>::high());
  }

  Float rise_, ca_, ab_, height_, beside_, over_, size_;
};

}  // namespace touchstone::robust::filters
