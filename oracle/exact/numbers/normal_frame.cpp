// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/normal_frame.h"

namespace touchstone::oracle {
namespace {

Vector3<Integer> across(const Vector3<Integer>& n) {
  if (sgn(n.x) == 0 && sgn(n.y) == 0) return {Integer(1), Integer(0), Integer(0)};
  return {Integer(-n.y), n.x, Integer(0)};
}

}  // namespace

NormalFrame::NormalFrame(const Vector3<Integer>& normal)
    : n_(normal), a_(across(n_)), b_(cross(n_, a_)), nn_(dot(n_, n_)), aa_(dot(a_, a_)) {}

Vector3<Rational> NormalFrame::with_product(const Rational& with_normal, const Vector3<Integer>& v) const {
  // The sum of multiples of n, a and b, in units of 1 / (n . n a . a denominator).
  const Integer& denominator = with_normal.get_den();
  const Vector3<Integer> parts{Integer(with_normal.get_num() * aa_), Integer(dot(v, a_) * nn_ * denominator),
                               Integer(dot(v, b_) * denominator)};
  const Integer below = nn_ * aa_ * denominator;
  const auto sum = [&](const Integer& n, const Integer& a, const Integer& b) {
    Rational component(Integer(parts.x * n + parts.y * a + parts.z * b), below);
    component.canonicalize();
    return component;
  };
  return {sum(n_.x, a_.x, b_.x), sum(n_.y, a_.y, b_.y), sum(n_.z, a_.z, b_.z)};
}

}  // namespace touchstone::oracle
