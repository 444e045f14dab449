// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// An orthogonal basis of space on integers: a normal n that is not 0, a vector a perpendicular to it, and b = n x a. A
/// velocity is recomposed from its parts along these, with one of them changed.
class NormalFrame {
 public:
  explicit NormalFrame(const Vector3<Integer>& normal);

  /// The vector whose scalar product with n is that number, and whose products with a and b are those of v.
  Vector3<Rational> with_product(const Rational& with_normal, const Vector3<Integer>& v) const;

 private:
  Vector3<Integer> n_, a_, b_;
  Integer nn_, aa_;  // b . b is their product
};

}  // namespace touchstone::oracle
