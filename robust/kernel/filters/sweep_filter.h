// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for moving spheres: the model, the guards and the rules of filters.h.
///
/// c and v are the position and the velocity of a as b sees them, r the sum of the radii, which are not negative, and
/// w = v + c where a is at t = 1; capitals are what is computed of them. ec and ev are the sums of the magnitudes of
/// the three coordinates, and what is computed for them is at least (1 - u)^3 times that. By (1), C and V are off by u,
/// and W, with a rounding of its own, by (1 + u)^2 - 1, in units of |c|, |v| and g = |v| + |c|, coordinate by
/// coordinate. A product of two numbers that are off by (1 + u)^i - 1 and (1 + u)^j - 1 comes out off by (1 + u)^(i + j
/// + 1) - 1, and a sum of three adds two to the power. A last operation that is a subtraction counts as a factor 1 + u
/// (4). At the end C is chosen as (5) says: of the units as computed and the two operations of the bound, (1 - u)^m is
/// left.
///
/// Underflow, where the guard ec + ev + r <= H holds: C and V are off by 5 n, W by 14 n; a product of two of them by at
/// most 28 n times the sum of the magnitudes of its factors (3 n of them for factors read as zero); all sums of three
/// products together with r^2, and (6), stay below 512 n H.
///
/// Proved: sweep_start, sweep_slope_at_start and so on. For the two slopes one u less than here would be enough.
namespace touchstone::robust::filters {

/// The signs known about a sweep, each certain or unknown.
template <class Float, class Format = FloatFormat<Float>>
class Sweep {
  using B = Bounds<Float, Format>;

 public:
  Sweep(const Sphere3<Float>& a, const Sphere3<Float>& b, const Vector3<Float>& velocity_a,
        const Vector3<Float>& velocity_b)
      : c_(a.center - b.center),
        v_{Float(velocity_a.x - velocity_b.x), Float(velocity_a.y - velocity_b.y), Float(velocity_a.z - velocity_b.z)},
        w_{Float(v_.x + c_.x), Float(v_.y + c_.y), Float(v_.z + c_.z)},
        r_(a.radius + b.radius),
        ec_(extent<Float, Format>(c_.x, c_.y, c_.z)),
        ev_(extent<Float, Format>(v_.x, v_.y, v_.z)),
        size_(ec_ + ev_ + r_) {}

  /// c . c - r^2: positive: apart at the start; negative: they overlap there.
  ///
  /// The sum of the squares is itself the extent, as for `circle` in filters.h. The computed squared distance lies
  /// between (1 - u)^5 and (1 + u)^5 of the exact one, the squared radius between (1 - u)^3 and (1 + u)^3. If the first
  /// comes out greater and should not be, the difference is at most ((1 + u)^5 - (1 - u)^3) / ((1 + u)^5 + (1 - u)^3)
  /// of the computed sum; conversely at most ((1 + u)^3 - (1 - u)^5) / ((1 + u)^3 + (1 - u)^5). Both are below
  /// 4 u. m = 3. C = 4 u + 20 u^2: at u = 1/16, 1.290 < 1.312 in units of 4 u.
  Sign start() const {
    const Float distance = dot(c_, c_), radius = r_ * r_;
    return certain<Float, Format>(distance - radius, B::template relative<8, 20>() * (distance + radius) + absolute(),
                                  size_, B::high());
  }

  /// c . v, half the first derivative at the start: positive: they part.
  ///
  /// (1 + u)^5 - 1 in units of ec ev, of which (1 - u)^7 is computed. m = 9. C = 5 u + 96 u^2: at u = 1/16, 2.026 < 2.2
  /// in units of 5 u.
  Sign slope_at_start() const {
    return certain<Float, Format>(dot(c_, v_), B::template relative<10, 96>() * ec_ * ev_ + absolute(), size_,
                                  B::high());
  }

  /// v . w, half the first derivative at the end: negative: they approach all the time.
  ///
  /// (1 + u)^6 - 1 in units of the sum of |v| g <= ev (ec + ev), of which (1 - u)^8 is computed. m = 10. C = 6 u + 128
  /// u^2: at u = 1/16, 2.231 < 2.333 in units of 6 u.
  Sign slope_at_end() const {
    return certain<Float, Format>(dot(v_, w_), B::template relative<12, 128>() * ev_ * (ec_ + ev_) + absolute(), size_,
                                  B::high());
  }

  /// w . w - r^2: positive: apart at the end; negative: they overlap there.
  ///
  /// (1 + u)^7 - 1 in units of the sum of g^2 <= (ec + ev)^2, and less in units of r^2; 1 + u for the subtraction. At
  /// least (1 - u)^10 of the units is computed. m = 12. C = 7 u + 256 u^2: at u = 1/16, 2.786 < 3.285 in units of 7 u.
  Sign end() const {
    const Float radius = r_ * r_, e = ec_ + ev_;
    return certain<Float, Format>(dot(w_, w_) - radius, B::template relative<14, 256>() * (e * e + radius) + absolute(),
                                  size_, B::high());
  }

  /// |c x v|^2 - r^2 v . v: positive: the line on which a moves passes by; negative: it enters.
  ///
  /// A coordinate of c x v is off by (1 + u)^4 - 1 in units of its two products, the sum of the three squares by
  /// (1 + u)^11 - 1 in units of (ec ev)^2, and r^2 v . v by (1 + u)^9 - 1 in units of (r ev)^2; 1 + u for the
  /// subtraction. At least (1 - u)^16 of ev^2 (ec^2 + r^2) is computed. m = 18. C = 11 u + 1024 u^2: at u = 1/16, 4.683
  /// < 6.818 in units of 11 u. (Looser than it could be: where c and v are along each other, the products of c x v
  /// cancel all the same.)
  ///
  /// The guard is G = 2^g, g a sixth of the range. A coordinate of c x v is off by less than 40 n G for underflow (3)
  /// and at most G^2, so its square is off by 100 n G^3; r^2 and v . v are off by 60 n G and at most G^2, their product
  /// by 150 n G^3; the bound's magnitudes likewise, times C < 5. All of it stays below 4096 n G^3.
  Sign passage() const {
    const int g = Format::max_exponent / 6;
    const Vector3<Float> x{c_.y * v_.z - c_.z * v_.y, c_.z * v_.x - c_.x * v_.z, c_.x * v_.y - c_.y * v_.x};
    const Float radius = r_ * r_, terms = ev_ * ev_ * (ec_ * ec_ + radius);
    const Float least = Format::above(power_of_two(12 + Format::min_exponent + 3 * g));
    return certain<Float, Format>(dot(x, x) - radius * dot(v_, v_), B::template relative<22, 1024>() * terms + least,
                                  size_, Format::above(power_of_two(g)));
  }

 private:
  static Float absolute() { return B::absolute_of_several(); }

  Vector3<Float> c_, v_, w_;
  Float r_, ec_, ev_, size_;
};

}  // namespace touchstone::robust::filters
