// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "robust/kernel/float_format.h"

/// The first stage: signs of polynomials, certain or unknown, from a few floating-point operations and a bound on their error.
///
/// Every filter is a straight line: differences of the input, the polynomial, the maxima that bound its terms, a guard on those maxima,
/// one comparison. It is a template on the number type, and all its constants follow from that type's FloatFormat, so that a toy
/// format can be tried on all of its numbers.
///
/// Model. u = 2^(1 - precision), n = 2^min_exponent. The result of one operation on x and y is exact * (1 + e) + h with |e| <= u.
/// That holds to nearest, upwards, downwards and towards zero (to nearest alone it would hold with u/2), and a compiler that contracts
/// a * b + c to FMA only leaves roundings out. h is what underflow costs: a result flushed to zero (FTZ) is off by less than n, an
/// operand read as zero (DAZ) by less than n before it is added, and by less than n times the other factor before it is multiplied.
/// Gradual underflow costs less. Overflow, NaN and infinity are kept out by the guards: a comparison with NaN is false, and false is
/// "unknown".
///
/// Three facts that the derivations below share, for u <= 1/16:
/// (1) A difference d of two input numbers comes out as D with |D - d| <= u |d| + 4 n. With |D| <= m and d <= (m + 4 n) / (1 - u) that is
///     at most (k + 5 n / m) m, where k = u / (1 - u) <= u + 1.07 u^2.
/// (2) Maxima are at least L and at most H, where L^2 >= 16 n / u^2 and L <= 1/2, so n / L^2 <= u^2 / 16 and n / L <= u^2 / 32. All
///     absolute terms of a polynomial of second degree together then stay below 2 u^2 times its scale: it has at most 3 products, whose
///     factors cost at most 13 n / L each and whose rounding costs n / L^2, and two sums that cost 4 n / L^2 each. 39 n / L + 11 n / L^2 <
///     2 u^2. Neither does the bound itself underflow: u L^2 > n.
/// (3) An inequality between power series in u with positive coefficients that agree at u = 0 and whose smaller side is convex holds
///     on [0, 1/16] against a linear larger side if it holds at 1/16.
namespace touchstone::robust::filters {

enum class Sign { negative, unknown, positive };

/// The constants of one format, in units of u.
template <class Float, class Format = FloatFormat<Float>>
struct Bounds {
  static_assert(Format::precision >= 5, "u <= 1/16 is used throughout");
  static constexpr double u = power_of_two(1 - Format::precision);

  /// Guards of polynomials of second degree: see (2); 2 (1 + u)^2 H^2 is finite.
  static constexpr int low_exponent = (Format::min_exponent + 2 * Format::precision + 3) >> 1;
  static constexpr int high_exponent = (Format::max_exponent - 2) >> 1;
  static_assert(low_exponent <= -1, "the exponent range is too small for the precision");

  /// Guards where two such polynomials are multiplied: the product of two bounds neither underflows, u L^4 > n, nor overflows,
  /// 4 (1 + u)^5 H^4 is finite.
  static constexpr int low_exponent_4 = (Format::min_exponent + Format::precision + 3) >> 2;
  static constexpr int low_of_products = low_exponent_4 > low_exponent ? low_exponent_4 : low_exponent;
  static constexpr int high_of_products = (Format::max_exponent - 3) >> 2;

  static Float low() { return Format::above(power_of_two(low_exponent)); }
  static Float high() { return Format::above(power_of_two(high_exponent)); }
  static Float low_products() { return Format::above(power_of_two(low_of_products)); }
  static Float high_products() { return Format::above(power_of_two(high_of_products)); }
};

template <class Float>
Float larger(const Float& a, const Float& b) {
  return a < b ? b : a;
}

/// The larger coordinate of a vector in magnitude.
template <class Float, class Format = FloatFormat<Float>>
Float extent(const Vector2<Float>& v) {
  return larger(Format::magnitude(v.x), Format::magnitude(v.y));
}

template <class Float>
bool within(const Float& low, const Float& a, const Float& b, const Float& high) {
  return (a < b ? a : b) >= low && larger(a, b) <= high;
}

/// The sign of a computed value that is off by less than error.
template <class Float, class Format = FloatFormat<Float>>
Sign certain(const Float& value, const Float& error) {
  if (!(Format::magnitude(value) > error)) return Sign::unknown;
  return value > error ? Sign::positive : Sign::negative;
}

/// The sign of v.x * w.y - v.y * w.x, each coordinate a computed difference of two input numbers, or an input number.
///
/// Scale M = extent(v) extent(w), all in units of it. A product of two differences is off by u (its rounding) + 2 k + k^2 (1), and at
/// most 1 + u; the subtraction rounds a number of at most 2 (1 + u). Together with (2)
///   2 (u + 2 k + k^2) + 2 u (1 + u) + 2 u^2 <= 8 u + 10.6 u^2 =: T.
/// The bound is computed in two products, which may lose a factor (1 - u)^2: C (1 - u)^2 >= T for C = 8 u (1 + 4 u), because
/// (8 u + 32 u^2) (1 - 2 u) >= 8 u + 12 u^2 for u <= 1/16.
template <class Float, class Format = FloatFormat<Float>>
Sign cross(const Vector2<Float>& v, const Vector2<Float>& w) {
  using B = Bounds<Float, Format>;
  const Float value = v.x * w.y - v.y * w.x;
  const Float ev = extent<Float, Format>(v), ew = extent<Float, Format>(w);
  if (!within(B::low(), ev, ew, B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(8 * B::u * (1 + 4 * B::u)) * ev * ew);
}

/// Positive: p lies left of p0 -> p1; negative: right.
template <class Float, class Format = FloatFormat<Float>>
Sign orientation(const Point2<Float>& p0, const Point2<Float>& p1, const Point2<Float>& p) {
  return cross<Float, Format>(p1 - p0, p - p0);
}

/// The sign of radius^2 - v.x^2 - v.y^2, v a computed difference of two points: positive inside the circle.
///
/// In units of the square of the largest of |v.x|, |v.y|, |radius|: the squares of v are off by u + 2 k + k^2 each, the square of the
/// radius by u; the sum rounds a number of at most 2 (1 + u), the difference one of at most 2 (1 + u)^2 (both are positive).
///   2 (u + 2 k + k^2) + u + 2 u (1 + u) + 2 u (1 + u)^2 + 2 u^2 <= 11 u + 14.8 u^2
/// and C = 11 u (1 + 4 u) is enough: (11 + 14.8 u) / (1 - u)^2 <= 11 + 44 u by (3), 13.57 <= 13.75 at 1/16.
template <class Float, class Format = FloatFormat<Float>>
Sign circle(const Vector2<Float>& v, const Float& radius) {
  using B = Bounds<Float, Format>;
  const Float value = radius * radius - (v.x * v.x + v.y * v.y);
  const Float scale = larger(extent<Float, Format>(v), Format::magnitude(radius));
  if (!(scale >= B::low() && scale <= B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(11 * B::u * (1 + 4 * B::u)) * scale * scale);
}

/// The sign of y - (slope * x + intercept): positive above the line.
///
/// In units of the largest of |slope * x|, |intercept|, |y|: the product is off by k, the sum rounds a number of at most 2 + k, the
/// difference one of at most 1 + (2 + k) (1 + u). (With FMA the product is exact instead, and at most 1 + k.) Underflow: a factor read
/// as zero costs n H each, as both factors are at most H; with a scale of at least 4 n H / u^2 that and the rest of h cost 2 u^2.
///   k + u (2 + k) + u (1 + (2 + k) (1 + u)) + 2 u^2 <= 6 u + 7.4 u^2
/// and C = 6 u (1 + 3 u) is enough: (6 u + 18 u^2) (1 - u) >= 6 u + 10.8 u^2 for u <= 1/16.
template <class Float, class Format = FloatFormat<Float>>
Sign elevation(const Float& slope, const Float& intercept, const Point2<Float>& p) {
  using B = Bounds<Float, Format>;
  constexpr int low_exponent = B::high_exponent + Format::min_exponent + 2 * Format::precision;
  const Float product = slope * p.x;
  const Float value = p.y - (product + intercept);
  const Float scale =
      larger(Format::magnitude(product), larger(Format::magnitude(intercept), Format::magnitude(p.y)));
  const Float factor = larger(Format::magnitude(slope), Format::magnitude(p.x));
  if (!(scale >= Format::above(power_of_two(low_exponent)) && larger(scale, factor) <= B::high())) return Sign::unknown;
  return certain<Float, Format>(value, Format::above(6 * B::u * (1 + 3 * B::u)) * scale);
}

/// Two products of two determinants each, of which the larger decides. d1 to d4 are computed as in `cross`, each with scale at most M =
/// e1 e2, and |product| > bound says that both factors have a certain sign: if either were off by its whole size, at most T M, the
/// other is at most 2 (1 + u)^2 M, and their product at most 2 T (1 + u)^3 M^2. M and the bound lose (1 - u)^4 at most, and
/// B = 16 u (1 + 12 u) is enough: 2 (8 + 10.6 u) (1 + u)^3 / (1 - u)^4 <= 16 + 192 u by (3), 26.9 <= 28 at 1/16.
template <class Float, class Format = FloatFormat<Float>>
Sign larger_product(const Float& p, const Float& q, const Float& e1, const Float& e2) {
  using B = Bounds<Float, Format>;
  if (!within(B::low_products(), e1, e2, B::high_products())) return Sign::unknown;
  const Float scale = e1 * e2;
  return certain<Float, Format>(larger(p, q), Format::above(16 * B::u * (1 + 12 * B::u)) * scale * scale);
}

/// Whether two segments meet: negative: they cross; positive: a line of one has the other on one side.
///
/// They cross where the ends of each lie on different sides of the other's line: both products of sides are negative. So the larger
/// product decides, whatever its sign. A NaN or an infinity in any coordinate gets into both products.
template <class Float, class Format = FloatFormat<Float>>
Sign segments(const Segment2<Float>& a, const Segment2<Float>& b) {
  const Vector2<Float> r = a.b - a.a, s = b.b - b.a;
  const Vector2<Float> aa = a.a - b.a, ab = a.b - b.a, bb = a.a - b.b;
  const Float p = (r.x * aa.y - r.y * aa.x) * (r.x * bb.y - r.y * bb.x);
  const Float q = (s.x * aa.y - s.y * aa.x) * (s.x * ab.y - s.y * ab.x);
  const Float directions = larger(extent<Float, Format>(r), extent<Float, Format>(s));
  const Float between =
      larger(extent<Float, Format>(aa), larger(extent<Float, Format>(ab), extent<Float, Format>(bb)));
  return larger_product<Float, Format>(p, q, directions, between);
}

/// Whether a ray and a segment meet: negative: they cross; positive: they do not.
///
/// With v the ray's direction, A and B the segment's ends seen from the origin and s = B - A: the ends lie on different sides of the ray's line
/// where (v x A) (v x B) < 0, and then t = (A x s) / (v x s) has the sign of (A x s) (v x B). If that product is negative there is no
/// common point even where the ends lie on one side. So the larger of the first product and minus the second decides.
template <class Float, class Format = FloatFormat<Float>>
Sign ray(const Point2<Float>& origin, const Vector2<Float>& v, const Segment2<Float>& segment) {
  const Vector2<Float> a = segment.a - origin, b = segment.b - origin, s = segment.b - segment.a;
  const Float vb = v.x * b.y - v.y * b.x;
  const Float p = (v.x * a.y - v.y * a.x) * vb;
  const Float q = (a.y * s.x - a.x * s.y) * vb;
  const Float directions = larger(extent<Float, Format>(v), extent<Float, Format>(s));
  const Float between = larger(extent<Float, Format>(a), extent<Float, Format>(b));
  return larger_product<Float, Format>(p, q, directions, between);
}

}  // namespace touchstone::robust::filters
