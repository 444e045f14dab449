// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/face_filter.h"

/// The first stage for rays against triangles and balls in space: the model, the guards and the rules of filters.h.
namespace touchstone::robust::filters {

/// With e = b - a, f = c - a and s from a to the origin, the line crosses the triangle's plane where a + x e + y f =
/// origin + t v, and x, y, t are quotients of the values of `beside_ca`, `beside_ab` and `height` by that of `rise`
/// (Moeller and Trumbore, Fast, minimum storage ray/triangle intersection, 1997).
///
/// One bound for the four values that contain v. X, Y and Z are the sums of |e|, |f| and |s| on each axis; the products
/// of all four values together are among those of |v.x| Y Z + |v.y| Z X + |v.z| X Y, each once, and those of `height`
/// among those of X Y Z. A product of beside_bc goes through two differences, two products, the difference in the cross
/// product, two sums and two differences: nine roundings, the last of which is shared (4); the other values have fewer.
/// At least (1 - u)^10 of the terms is computed, (1 - u)^11 of X Y Z, and the bound has two operations more: C (1 -
/// u)^13 >= (1 + u) ((1 + u)^8 - 1) = 8 u + .... C = 8 u + 288 u^2: at u = 1/16, 2.879 < 3.25 in units of 8 u. (Looser
/// by more than two than it could be: a product of one of the values is a ninth of the terms, and the roundings are
/// taken for independent.)
///
/// Guard and absolute terms: as for FacePlane, of which rise and height have the products; beside_bc has three such
/// values, less than 550 n H^2, and two more differences, so twice the absolute term pays for it. Proved: ray_rise and
/// so on.
template <class Float, class Format = FloatFormat<Float>>
class RayAndTriangle {
  using B = CubicBounds<Float, Format>;

 public:
  RayAndTriangle(const Point3<Float>& origin, const Vector3<Float>& v, const Point3<Float>& a, const Point3<Float>& b,
                 const Point3<Float>& c)
      : v_(v), e_(b - a), f_(c - a), s_(origin - a), p_(cross(v_, f_)), q_(cross(s_, e_)) {
    const Float x = extent<Float, Format>(e_.x, f_.x, s_.x), y = extent<Float, Format>(e_.y, f_.y, s_.y),
                z = extent<Float, Format>(e_.z, f_.z, s_.z), yz = y * z;
    const Float vx = Format::magnitude(v.x), vy = Format::magnitude(v.y), vz = Format::magnitude(v.z);
    terms_ = vx * yz + vy * (z * x) + vz * (x * y);
    volume_ = x * yz;
    size_ = x + y + z + vx + vy + vz;
  }

  /// e . (v x f): positive if the triangle is seen clockwise along the ray.
  Sign rise() const { return sign(dot(e_, p_)); }
  /// These have the sign of rise if the line passes the edge on the inner side.
  Sign beside_ca() const { return sign(dot(s_, p_)); }
  Sign beside_ab() const { return sign(dot(v_, q_)); }
  Sign beside_bc() const { return sign(dot(e_, p_) - dot(s_, p_) - dot(v_, q_)); }
  /// This has the sign of rise if the crossing is ahead of the origin.
  Sign height() const { return certain<Float, Format>(dot(f_, q_), error(volume_), size_, B::high()); }

 private:
  static Float error(const Float& terms) {
    const int h = Format::max_exponent / 4;
    const Float absolute = Format::above(power_of_two(10 + Format::min_exponent + 2 * h));
    return Bounds<Float, Format>::template relative<16, 288>() * terms + absolute;
  }
  Sign sign(const Float& value) const { return certain<Float, Format>(value, error(terms_), size_, B::high()); }

  Vector3<Float> v_, e_, f_, s_, p_, q_;
  Float terms_, volume_, size_;
};

/// Decides whether a ray meets a ball. Positive: it does, and enters it or starts inside; negative: it does not.
///
/// With c from the ball's center to the origin, |c + t v|^2 - r^2 is start + 2 slope t + v . v t^2. The ray meets the
/// ball if value = slope^2 - v . v start is positive, and start or slope is negative; it misses it if value is
/// negative, or start and slope are positive. By Cauchy's inequality the units are the squares of the lengths, which
/// are computed anyway: the sum of all |c_i v_i| is at most |c| |v|.
///
/// start: a product goes through two differences, the product and two sums, and one shared subtraction (4): (1 + u)^5 -
/// 1 in units of |c|^2 + r^2, of which (1 - u)^5 is computed; two operations more. C = 5 u + 128 u^2: at u = 1/16, 2.02
/// < 2.6 in units of 5 u.
///
/// value: a product of v . v start goes through three roundings for v . v, six for start and one, and those of slope^2
/// through nine; the last subtraction is shared. Both have their products among |v|^2 (|c|^2 + r^2), so twice these are
/// the units, of which (1 - u)^9 is computed; two operations more. C = 20 u + 1024 u^2: at u = 1/16, 3.07 < 4.2 in
/// units of 20 u. (Looser than two: the roundings are taken for independent.)
///
/// slope has no bound: it is off by (1 + u)^4 - 1 in units of |c| |v|, and asked only where value and start are
/// certainly positive. Then slope^2 is more than a value's bound, 20 u |c|^2 |v|^2, which is more than the square of
/// what slope is off.
///
/// Guard and absolute terms: a sum of squares of at most G^2 holds each number to little more than G; then as for
/// Sweep::passage, 512 n G^3 for value. start and slope are off by less than 64 n G. The absolute terms are greater, so
/// that no number that is asked for its sign is read as zero. Proved: ray_and_ball.
template <class Float, class Format = FloatFormat<Float>>
class RayAndBall {
  using B = Bounds<Float, Format>;

 public:
  RayAndBall(const Point3<Float>& origin, const Vector3<Float>& v, const Sphere3<Float>& ball)
      : c_(origin - ball.center),
        square_(ball.radius * ball.radius),
        way_(dot(c_, c_)),
        speed_(dot(v, v)),
        slope_(dot(c_, v)),
        reach_(way_ + square_),
        size_(reach_ + speed_) {}

  Sign meets() const {
    const int g = Format::max_exponent / 6;
    const Float start = way_ - square_, value = slope_ * slope_ - speed_ * start;
    const Float least = Format::above(power_of_two(12 + Format::min_exponent + g)),
                absolute = Format::above(power_of_two(12 + Format::min_exponent + 3 * g));
    const int beside = Format::magnitude(start) > B::template relative<10, 128>() * reach_ + least,
              apart = Format::magnitude(value) > B::template relative<40, 1024>() * (speed_ * reach_) + absolute,
              guarded = size_ <= Format::above(power_of_two(2 * g));
    if ((beside & apart & guarded) == 0) [[unlikely]]  // one branch
      return Sign::unknown;
    const Float nearest = start < slope_ ? start : slope_;
    return (value > Float()) & (nearest < Float()) ? Sign::positive : Sign::negative;
  }

 private:
  Vector3<Float> c_;
  Float square_, way_, speed_, slope_, reach_, size_;
};

}  // namespace touchstone::robust::filters
