// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <initializer_list>
#include <vector>

#include "geometry/triangles.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The part of a segment p + t (q - p), 0 <= t <= 1, or of a ray, 0 <= t, on which linear functions are not negative,
/// exactly. first and last are t as numerator / denominator > 0; last of an unbounded ray is 1 / 0, greater than all
/// others. p == q is one point for every t; first and last stay 0 and 1.
struct Clipped {
  struct Parameter {
    mpz_class numerator, denominator;
    friend bool operator<(const Parameter& s, const Parameter& t) {
      return s.numerator * t.denominator < t.numerator * s.denominator;
    }
  };

  Parameter first{0, 1}, last{1, 1};
  bool empty = false, endless = false;

  static Clipped ray() { return {{0, 1}, {1, 0}, false, true}; }

  /// Keeps the part on which a function with these values at p and q is >= 0.
  void keep(const mpz_class& at_p, const mpz_class& at_q);
  void keep_zero(const mpz_class& at_p, const mpz_class& at_q) { keep(at_p, at_q), keep(-at_p, -at_q); }
};

/// The part of segment / w, w > 0, in a triangle, which may have no area; or of a ray, from the segment's a through its
/// b.
Clipped clipped(const Segment3<mpz_class>& segment, const Triangle3<mpz_class>& triangle, const mpz_class& w = 1,
                Clipped part = {});

/// p / w, w > 0.
struct HomogeneousPoint {
  Point3<mpz_class> p;
  mpz_class w;
};

/// Divides the numbers by their greatest common divisor, so that what is computed from them stays short.
void reduce(std::initializer_list<mpz_class*> numbers);

/// q - p, times a positive number.
Vector3<mpz_class> displacement(const HomogeneousPoint& p, const HomogeneousPoint& q);
inline bool zero(const Vector3<mpz_class>& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; }

/// The ends of the parts that the edges of each triangle have in the other. Every extreme point of the common part lies
/// on an edge of one of the two: a point inside both, coplanar or not, lies between others. So the common part is the
/// convex hull of these ends, which are reduced.
std::vector<HomogeneousPoint> ends_of_common_part(const Triangle3<mpz_class>& a, const Triangle3<mpz_class>& b);

}  // namespace touchstone::robust::kernel
