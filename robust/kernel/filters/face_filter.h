// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for planes through three points: the model, the guards and the rules (1), (4) and (5) of filters.h.
namespace touchstone::robust::filters {

/// The constants of polynomials of degree three.
template <class Float, class Format = FloatFormat<Float>>
struct CubicBounds {
  static_assert(3 * (Format::max_exponent / 4) + 1 <= Format::max_exponent, "2 H^3 is finite");
  static_assert(9 + Format::min_exponent + 2 * (Format::max_exponent / 4) <= Format::max_exponent);

  /// H: a quarter of the range, so that about as much room is left below, where the absolute term hides everything, as
  /// above.
  static constexpr int high_exponent = Format::max_exponent / 4;
  static Float high() { return Format::above(power_of_two(high_exponent)); }
  /// 512 n H^2
  static Float absolute() { return Format::above(power_of_two(9 + Format::min_exponent + 2 * high_exponent)); }
};

/// The side of the plane through three points on which other points lie. The part that depends on the three alone is
/// computed once, for many points.
///
/// E = ((b - a) x (c - a)) . (p - a) has six products of three differences; let P be the sum of their magnitudes, taken
/// exactly. A product goes through three differences, two products, the difference in the normal and at most two sums:
/// eight roundings, the last of which is shared and cannot make a sign wrong by (4). So a value of the wrong sign is at
/// most (1 + u) ((1 + u)^7 - 1) P (FMA only leaves roundings out). The terms, the same products as magnitudes, are
/// computed as at least (1 - u)^8 P, and the bound has two operations more: C (1 - u)^10 >= (1 + u) ((1 + u)^7 - 1) = 7
/// u + .... C = 7 u + 176 u^2: at u = 1/16, 2.449 < 2.571 in units of 7 u. (Looser by more than two than it could be:
/// the eight roundings are taken for independent and for one direction; nothing is known that needs half.)
///
/// Guard: the magnitudes of all nine differences add up to at most H, as computed, so each is at most H. P holds each
/// of its products once, the cube of that sum six times: nothing computed exceeds 2 H^3.
///
/// Absolute terms, for u <= 1/16 and H >= 1, in units of n H^2: by (1) and DAZ a product of two differences is off by
/// less than 12 n H (4 n (1 + u) and n for either factor, times the other, rounded, and n), a coordinate of the normal
/// by less than 30 n H (two of these, rounded, and 3 n), and it is at most 2.4 H^2. Its product with the third
/// difference: 34 for the coordinate's error times that difference, 10 for the difference's, 3.4 for DAZ, 1 for
/// itself; rounded, less than 52. Three of them, summed with two roundings, which make 1.13, and 6 n: less than 183.
/// The value: 1.0625 times that; the terms, which are too small by as much: C <= 1.125 times that; the bound itself:
/// 4. That is less than 405, and 512 (1 - u) pays for it. Proved: face_side.
template <class Float, class Format = FloatFormat<Float>>
class FacePlane {
 public:
  FacePlane(const Point3<Float>& a, const Point3<Float>& b, const Point3<Float>& c) : a_(a) {
    const Vector3<Float> v = b - a, w = c - a;
    normal_ = cross(v, w);
    const Vector3<Float> sizes{Format::magnitude(v.x), Format::magnitude(v.y), Format::magnitude(v.z)};
    const Vector3<Float> others{Format::magnitude(w.x), Format::magnitude(w.y), Format::magnitude(w.z)};
    terms_ = {sizes.y * others.z + sizes.z * others.y, sizes.z * others.x + sizes.x * others.z,
              sizes.x * others.y + sizes.y * others.x};
    extent_ = sizes.x + sizes.y + sizes.z + others.x + others.y + others.z;
  }

  /// The sign of E: positive if a, b, c are seen counter-clockwise.
  Sign side(const Point3<Float>& p) const {
    using B = CubicBounds<Float, Format>;
    const Vector3<Float> d = p - a_;
    const Float x = Format::magnitude(d.x), y = Format::magnitude(d.y), z = Format::magnitude(d.z);
    const Float terms = terms_.x * x + terms_.y * y + terms_.z * z;
    const Float error = Bounds<Float, Format>::template relative<14, 176>() * terms + B::absolute();
    return certain<Float, Format>(dot(normal_, d), error, extent_ + (x + y + z), B::high());
  }

 private:
  Point3<Float> a_;
  Vector3<Float> normal_, terms_;
  Float extent_;
};

}  // namespace touchstone::robust::filters
