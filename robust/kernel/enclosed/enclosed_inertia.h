// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_shapes.h"

/// Two rotating bodies, one per lane, enclosed; `Bounded` checks the window of their numbers.
namespace touchstone::robust::kernel {

using EnclosedPair = Enclosed<Two>;
using EnclosedVectors = Vector3<EnclosedPair>;

inline EnclosedPair enclosed(Two exactly) { return {exactly, Two(), Two()}; }

/// Checks that nothing underflows or overflows and that every factor and divisor is settled. Checked once, at the end,
/// since the results computed after a defect do no harm.
///
/// Numbers of the input are 0 or between 2^-30 and 2^30 in size, so multiples of 2^-82, and polynomials of degree 3 in
/// them come out with all their tails, as multiples of 2^-246 (robust/kernel/enclosed/window.h says why). Later factors
/// and divisors are 0, with all terms 0, or between 2^-200 and 2^200: a product or quotient is above 2^-400 and below
/// 2^400, and its bound above 2^-480. The underflow of its tail, or that of a sum, is below 2^-1022 each
/// time, times at most 2^400 afterwards: every bound has that to spare.
class Bounded {
 public:
  template <class... Numbers>
  void inputs(Numbers... numbers) {
    (look(numbers, 0x1p-30, 0x1p30), ...);
  }
  const EnclosedPair& operator()(const EnclosedPair& x) {
    look(x.high, 0x1p-200, 0x1p200);
    const Two rest = Format::magnitude(x.low) + x.error;
    outside_ |= ~(Format::magnitude(x.high).lanes >= (Format::above(16) * rest).lanes);
    return x;
  }
  Enclosed<double> operator()(const Enclosed<double>& x) { return first((*this)(twice(x))); }
  EnclosedVectors operator()(const EnclosedVectors& v) { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }
  bool hold() const { return (outside_[0] | outside_[1]) == 0; }

 private:
  using Format = filters::FloatFormat<Two>;
  /// A comparison may read a subnormal as zero, which is small too, so the bits decide whether it is zero. NaN is not
  /// at most 2^200.
  void look(Two x, double least, double most) {
    const Two::Lanes size = Format::magnitude(x).lanes;
    outside_ |= ((size < Two(least).lanes) & reinterpret_cast<Two::Bits>(size)) | ~(size <= Two(most).lanes);
  }

  Two::Bits outside_{};
};

/// v . w
inline EnclosedPair enclosed_dot(const EnclosedVectors& v, const EnclosedVectors& w) {
  return v.x * w.x + v.y * w.y + v.z * w.z;
}
/// p q - r s
inline EnclosedPair enclosed_minor(const Factor<Two>& p, const Factor<Two>& q, const Factor<Two>& r,
                                   const Factor<Two>& s) {
  return (Sum(product(p, q)) -= product(r, s)).value();
}
/// v x w
inline EnclosedVectors enclosed_cross(const Vector3<Factor<Two>>& v, const Vector3<Factor<Two>>& w) {
  return {enclosed_minor(v.y, w.z, v.z, w.y), enclosed_minor(v.z, w.x, v.x, w.z), enclosed_minor(v.x, w.y, v.y, w.x)};
}

inline bool symmetric(const Inertiad& i) {
  return validation::same(i.x.y, i.y.x) && validation::same(i.x.z, i.z.x) && validation::same(i.y.z, i.z.y);
}

/// A symmetric matrix for each of two bodies, and its adjugate, also symmetric.
class EnclosedInertia {
 public:
  EnclosedInertia(const Inertiad& a, const Inertiad& b, Bounded& bounded)
      : xx_(a.x.x, b.x.x),
        xy_(a.x.y, b.x.y),
        xz_(a.x.z, b.x.z),
        yy_(a.y.y, b.y.y),
        yz_(a.y.z, b.y.z),
        zz_(a.z.z, b.z.z) {
    bounded.inputs(xx_, xy_, xz_, yy_, yz_, zz_);
    const Factor<Two> xx = factor(xx_), xy = factor(xy_), xz = factor(xz_), yy = factor(yy_), yz = factor(yz_),
                      zz = factor(zz_);
    of_x_ = bounded({enclosed_minor(yy, zz, yz, yz), enclosed_minor(yz, xz, xy, zz), enclosed_minor(xy, yz, yy, xz)});
    of_y_ = {of_x_.y, bounded(enclosed_minor(zz, xx, xz, xz)), bounded(enclosed_minor(xz, xy, yz, xx))};
    of_z_ = {of_x_.z, of_y_.z, bounded(enclosed_minor(xx, yy, xy, xy))};
    determinant_ = bounded(enclosed_dot(of_x_, {enclosed(xx_), enclosed(xy_), enclosed(xz_)}));
  }

  /// Decides by the leading minors; settled numbers have their sign.
  bool positive_definite() const {
    const Two least(0x1p-300);
    return xx_ >= least && of_z_.z.high >= least && determinant_.high >= least;
  }

  /// The image of l under the matrix.
  EnclosedVectors turned_by(const EnclosedVectors& l) const {
    const Divisor d(determinant_);
    return {enclosed_dot(of_x_, l) / d, enclosed_dot(of_y_, l) / d, enclosed_dot(of_z_, l) / d};
  }

 private:
  Two xx_, xy_, xz_, yy_, yz_, zz_;
  EnclosedVectors of_x_, of_y_, of_z_;
  EnclosedPair determinant_;
};

}  // namespace touchstone::robust::kernel
