// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "geometry/triangles.h"
#include "geometry/validation.h"
#include "robust/kernel/filters/float_format.h"
#include "robust/kernel/filters/strict_math.h"

/// Signs of polynomials of differences, from a few floating-point operations, in every rounding mode: the type counts
/// the roundings.
namespace touchstone::robust::filters {

/// True if a number is 0, or of a magnitude in [2^-30, 2^30]: finite, and a multiple of 2^-82.
///
/// Polynomials of degree d <= 6 in such numbers, and all their computed parts, are multiples of 2^(-82 d) >= 2^-492
/// below 2^(31 d + 12): nothing underflows or overflows, so that FTZ and DAZ flush nothing. The bits decide, since a
/// subnormal may be read as zero, and their order is that of magnitudes.
inline bool moderate(double x) {
  constexpr auto least = std::bit_cast<std::uint64_t>(0x1p-30), most = std::bit_cast<std::uint64_t>(0x1p30);
  const std::uint64_t size = std::bit_cast<std::uint64_t>(x) << 1 >> 1;
  return (size - least <= most - least) | validation::zero(x);
}
inline bool moderate(const Vector3d& v) { return moderate(v.x) & moderate(v.y) & moderate(v.z); }
inline bool moderate(const Point3d& p) { return moderate(p.x) & moderate(p.y) & moderate(p.z); }
inline bool moderate(const Segment3d& s) { return moderate(s.a) & moderate(s.b); }
inline bool moderate(const Triangle3d& t) { return moderate(t.a) & moderate(t.b) & moderate(t.c); }

/// A sum of terms, and the sum of their magnitudes, each computed with at most `roundings` operations per term.
///
/// Model: that of filters.h, u = 2^-52, without underflow (`moderate`). Let S be the sum of the magnitudes of the exact
/// terms. Every term goes through at most k operations, so value is off by ((1 + u)^k - 1) S at most, and size is at
/// least (1 - u)^k S. For k <= 64 that is less than 2 k u size; FMA leaves roundings out. Not proved by machine.
template <int roundings>
struct Sized {
  static_assert(roundings <= 64);
  double value, size;

  double error() const { return roundings * 0x1p-51 * size; }
  bool positive() const { return value > error(); }
  bool negative() const { return value < -error(); }
  /// If all terms are zero, the sum is certainly 0.
  bool not_negative() const { return positive() | (size == 0); }
  bool not_positive() const { return negative() | (size == 0); }
};

inline constexpr int one_more(int j, int k) { return (j > k ? j : k) + 1; }

template <int j, int k>
Sized<j + k + 1> operator*(const Sized<j>& x, const Sized<k>& y) {
  return {x.value * y.value, x.size * y.size};
}
template <int j, int k>
Sized<one_more(j, k)> operator+(const Sized<j>& x, const Sized<k>& y) {
  return {x.value + y.value, x.size + y.size};
}
template <int j, int k>
Sized<one_more(j, k)> operator-(const Sized<j>& x, const Sized<k>& y) {
  return {x.value - y.value, x.size + y.size};
}

template <int k>
Sized<k> operator-(const Sized<k>& x) {
  return {-x.value, x.size};
}

template <int k>
Sized<k> magnitude(const Sized<k>& x) {
  return {FloatFormat<double>::magnitude(x.value), x.size};
}

/// The difference of two numbers of the input.
inline Sized<1> sized_difference(double a, double b) {
  const double d = a - b;
  return {d, FloatFormat<double>::magnitude(d)};
}
inline Sized<1> sized_sum(double a, double b) { return sized_difference(a, -b); }

template <class Number>
struct Triple {
  Number x, y, z;
};
template <class Number>
Triple(Number, Number, Number) -> Triple<Number>;

/// Vectors of numbers whose type depends on the operations: Sized, or kernel::Loose.
template <class X, class Y>
auto cross(const Triple<X>& v, const Triple<Y>& w) {
  return Triple{v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}
template <class X, class Y>
auto dot(const Triple<X>& v, const Triple<Y>& w) {
  return v.x * w.x + v.y * w.y + v.z * w.z;
}

/// q - p
inline Triple<Sized<1>> sized_between(const Point3d& p, const Point3d& q) {
  return {sized_difference(q.x, p.x), sized_difference(q.y, p.y), sized_difference(q.z, p.z)};
}

}  // namespace touchstone::robust::filters
