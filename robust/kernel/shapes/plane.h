// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"

/// Plane geometry on integers, written once for both exact stages: Integer is std::int64_t (a lattice, every product
/// fits 128 bits) or mpz_class. Positions and vectors are multiples of one power of two, which only rounding needs to
/// know.
namespace touchstone::robust::kernel {

template <class Integer>
struct Degrees;
template <>
struct Degrees<std::int64_t> {
  using Second = Int128;
  using Third = Int192;
};
template <>
struct Degrees<mpz_class> {
  using Second = mpz_class;
  using Third = mpz_class;
};
template <class Integer>
using Second = typename Degrees<Integer>::Second;
template <class Integer>
using Third = typename Degrees<Integer>::Third;

inline Int128 multiply(std::int64_t a, std::int64_t b) { return static_cast<Int128>(a) * b; }
inline mpz_class multiply(const mpz_class& a, const mpz_class& b) { return a * b; }

/// v.x * w.y - v.y * w.x
template <class Integer>
Second<Integer> determinant(const Vector2<Integer>& v, const Vector2<Integer>& w) {
  return multiply(v.x, w.y) - multiply(v.y, w.x);
}

/// 1, 0, -1: w lies counter-clockwise of v, along it, clockwise.
template <class Integer>
int turn(const Vector2<Integer>& v, const Vector2<Integer>& w) {
  return sign_of(determinant(v, w));
}
/// 1, 0, -1: p, q, r turn left, are collinear, turn right.
template <class Integer>
int turn(const Point2<Integer>& p, const Point2<Integer>& q, const Point2<Integer>& r) {
  return turn<Integer>(q - p, r - p);
}

/// Lexicographic: by x, then by y.
template <class Integer>
bool before(const Point2<Integer>& p, const Point2<Integer>& q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

/// t of a point p = a + t (b - a) that is known to lie on the line; 0 if a == b.
template <class Integer>
double parameter_on(const Point2<Integer>& p, const Segment2<Integer>& s) {
  const Second<Integer> dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  if (sign_of(dx) != 0) return round_quotient(Second<Integer>(p.x - s.a.x), dx);
  if (sign_of(dy) != 0) return round_quotient(Second<Integer>(p.y - s.a.y), dy);
  return 0;
}

/// a + (n / d) v, times 2^exponent, rounded.
template <class Integer>
Point2d point_along(const Point2<Integer>& a, const Vector2<Integer>& v, const Second<Integer>& n,
                    const Second<Integer>& d, int exponent) {
  const Third<Integer> x = multiply(d, a.x) + multiply(n, v.x), y = multiply(d, a.y) + multiply(n, v.y);
  return {round_quotient(x, d, exponent), round_quotient(y, d, exponent)};
}

}  // namespace touchstone::robust::kernel
